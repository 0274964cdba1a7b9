// SPDX-License-Identifier: GPL-3.0-or-later
// Where to divide a cell of the kd-tree: by the plane of least cost by the surface area heuristic
// (MacDonald and Booth, "Heuristics for Ray Tracing Using Space Subdivision", 1990), and into boxes
// around what of each item is on either side (perfect splits: Havran and Bittner, "On Improving
// KD-Trees for Ray Shooting", 2002). Called by the builder of nodes; a pure function of the items.
#pragma once

#include "index/spatial_splits.h"

#include <vector>

namespace candelabra {

/// A plane that divides a cell, square to an axis.
struct CellSplit {
    int axis = -1;  ///< -1: not dividing is cheapest
    double position = 0;
    double tolerance = 0;  ///< what reaches over it by no more than this is on one side

    bool found() const { return axis >= 0; }
    bool reaches_below(const Box& box) const { return box.low[axis] + tolerance < position; }
    bool reaches_above(const Box& box) const { return box.high[axis] - tolerance > position; }
};

/// What of items is on a side of a plane.
struct CellSide {
    std::vector<PrimRef> fragments;
    Box box;  ///< around them
};

/// The best plane for items within a box, or none when it is better not to divide them.
CellSplit find_cell_split(std::span<const PrimRef>, const Box&, const TreeSettings&, double slack);

/// Both sides of a plane. An item that passes through both stands in both, in boxes around its
/// parts there, which are made larger by `slack`; one that passes through neither is left out.
struct CellSides {
    CellSide below, above;
};
CellSides divide(std::span<const PrimRef>, const CellSplit&, const ItemPart&, double slack);

}  // namespace candelabra
