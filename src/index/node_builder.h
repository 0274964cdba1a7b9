// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the nodes of a tree, from the top down. Called by build_tree.
#pragma once

#include "index/spatial_splits.h"

namespace candelabra {

/// What nodes are built by.
struct NodeTask {
    TreeSettings costs;
    ItemPart part;     ///< empty: items are built in whole
    double slack = 0;  ///< of pieces, see pieces_of
    int threads = 1;
};

/// What a ray that passes a box, and only asks whether anything is in its way, may expect there.
struct OcclusionCost {
    double chance = 0;  ///< to be stopped
    double steps = 1;   ///< until that is known
};

/// The chance that a ray through a box is stopped by an item in it. What an item hides, its box
/// tells as much as is needed: the factor changes little.
double chance_to_stop(double item_area, double box_area);

/// Leaves have no more items than this.
inline constexpr std::size_t leaf_limit = 8;

/// A tree, or a part of it that does not know what is before it.
struct BuiltNodes {
    std::vector<TreeNode> nodes;    ///< the first is around all; those of one parent side by side
    std::vector<TreeFrame> frames;  ///< the first is that of the first node
    std::vector<std::uint32_t> leaves;  ///< see WideTree; the first one has no items
    OcclusionCost prospect;
};

/// Of items within a box; brings these into another order.
BuiltNodes build_nodes(const NodeTask&, std::span<PrimRef>, const Box&);

}  // namespace candelabra
