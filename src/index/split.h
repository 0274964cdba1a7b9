// SPDX-License-Identifier: GPL-3.0-or-later
// Divides the items of a box in two by the surface area heuristic (MacDonald and Booth, "Heuristics
// for Ray Tracing Using Space Subdivision", 1990), with the items' centres on both sides of a
// plane. Used by the builder of the hierarchy; a pure function of the items.
#pragma once

#include "index/wide_tree.h"

#include <cstdint>
#include <span>

namespace candelabra {

/// An item, or a piece of one, and its box.
struct PrimRef {
    Box box;
    std::uint32_t item = 0;
};

/// Cost of items that are tested in groups. An incomplete group takes the time of a full one, but
/// not its memory; halfway between both was fastest.
double cost_of_items(double items, const TreeSettings&);

/// A division of items.
struct Split {
    int axis = -1;        ///< -1: not dividing is cheapest
    double origin = 0;    ///< of the bins along the axis, in doubled coordinates
    double scale = 0;     ///< bins per unit of doubled coordinates
    int first_above = 0;  ///< the first bin of the upper side
    Box below, above;     ///< bounds of the items on each side

    bool found() const { return axis >= 0; }
    bool puts_below(const Box& box) const {
        return static_cast<int>((box.low[axis] + box.high[axis] - origin) * scale) < first_above;
    }
};

/// Returns the best division of items within a box, or none if not dividing them is cheaper. If
/// `forced`, returns none only if all centres coincide.
Split find_split(std::span<const PrimRef>, const Box&, const TreeSettings&, bool forced);

}  // namespace candelabra
