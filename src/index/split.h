// SPDX-License-Identifier: GPL-3.0-or-later
// How to divide a box's items in two: by the surface area heuristic (MacDonald and Booth,
// "Heuristics for Ray Tracing Using Space Subdivision", 1990), where the items' centres come to be
// on the two sides of a plane. Called by the builder of the hierarchy; a pure function of the
// items.
#pragma once

#include "index/wide_tree.h"

#include <cstdint>
#include <span>

namespace candelabra {

/// An item of a box that may still be divided.
struct PrimRef {
    Box box;
    std::uint32_t item = 0;
};

/// What items cost that are tested in groups: the last ones take the time of a full group, but not
/// its memory. Half way between both was fastest.
double cost_of_items(double items, const TreeSettings&);

/// A way to divide items.
struct Split {
    int axis = -1;        ///< -1: not dividing is cheapest
    double origin = 0;    ///< of the bins along the axis, in doubled coordinates
    double scale = 0;     ///< bins for each unit of doubled coordinates
    int first_above = 0;  ///< the bin where the upper side begins
    Box below, above;     ///< around the items of the sides

    bool found() const { return axis >= 0; }
    bool puts_below(const Box& box) const {
        return static_cast<int>((box.low[axis] + box.high[axis] - origin) * scale) < first_above;
    }
};

/// The best division of items within a box, or none when it is better not to divide them.
/// `forced`: the best one even then, and none only when all centres are in one place.
Split find_split(std::span<const PrimRef>, const Box&, const TreeSettings&, bool forced);

}  // namespace candelabra
