// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the nodes of a tree, top down. Used by build_tree.
#pragma once

#include "index/spatial_splits.h"

namespace candelabra {

/// Parameters of a build of nodes.
struct NodeTask {
    TreeSettings costs;
    ItemPart part;     ///< empty: items are not divided
    double slack = 0;  ///< enlargement of pieces, see pieces_of
    int threads = 1;
};

/// Expected result in a box for an occlusion ray that passes through it.
struct OcclusionCost {
    double chance = 0;  ///< probability of being occluded
    double steps = 1;   ///< expected steps until the result is known
};

/// Probability that an item in a box occludes a ray through it. The area of the item's box is
/// accurate enough as the area that it occludes: a factor changes little.
double chance_to_stop(double item_area, double box_area);

/// Maximum number of items of a leaf.
inline constexpr std::size_t leaf_limit = 8;

/// A tree, or a part of it that is independent of the nodes before it.
struct BuiltNodes {
    std::vector<TreeNode> nodes;        ///< the first is the root; siblings are adjacent
    std::vector<TreeFrame> frames;      ///< the first is the frame of the root
    std::vector<std::uint32_t> leaves;  ///< see WideTree; the first one has no items
    OcclusionCost prospect;
};

/// Builds nodes for items within a box; reorders the items.
BuiltNodes build_nodes(const NodeTask&, std::span<PrimRef>, const Box&);

}  // namespace candelabra
