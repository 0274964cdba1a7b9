// SPDX-License-Identifier: GPL-3.0-or-later
// Divides a cell of the kd-tree by the plane of least cost by the surface area heuristic (MacDonald
// and Booth, "Heuristics for Ray Tracing Using Space Subdivision", 1990), into boxes around the
// part of each item on either side (perfect splits: Havran and Bittner, "On Improving KD-Trees for
// Ray Shooting", 2002). Used by the builder of nodes; a pure function of the items.
#pragma once

#include "index/spatial_splits.h"

#include <vector>

namespace candelabra {

/// A plane perpendicular to an axis that divides a cell.
struct CellSplit {
    int axis = -1;  ///< -1: not dividing is cheapest
    double position = 0;
    double tolerance = 0;  ///< a box that crosses the plane by no more than this counts as on one
                           ///< side

    bool found() const { return axis >= 0; }
    bool reaches_below(const Box& box) const { return box.low[axis] + tolerance < position; }
    bool reaches_above(const Box& box) const { return box.high[axis] - tolerance > position; }
};

/// The parts of items on one side of a plane.
struct CellSide {
    std::vector<PrimRef> fragments;
    Box box;  ///< their bounding box
};

/// Returns the best plane for items within a box, or none if not dividing them is cheaper.
CellSplit find_cell_split(std::span<const PrimRef>, const Box&, const TreeSettings&, double slack);

/// Both sides of a plane. An item that passes through both is in both, with boxes around its parts
/// there that are enlarged by `slack`. An item that passes through neither is left out.
struct CellSides {
    CellSide below, above;
};
CellSides divide(std::span<const PrimRef>, const CellSplit&, const ItemPart&, double slack);

}  // namespace candelabra
