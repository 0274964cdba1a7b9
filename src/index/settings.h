// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of each index of what rays may meet: part of the scene, chosen by global_settings
// { index ... } or --index. Both build a WideTree, so rays walk them by the same steps.
#pragma once

#include "index/wide_tree.h"
#include "vocabulary/kinds.h"

namespace candelabra {

/// Space is divided by planes into cells that do not overlap; items stand in all cells that they
/// pass through (Bentley, "Multidimensional Binary Search Trees Used for Associative Searching",
/// 1975).
struct KdTree {
    double node_cost = 0.5;
    double group_cost = 1;
    double reference_cost = 0.2;

    static const ItemInfo vocabulary;
};
/// Items are divided into groups, whose boxes may overlap.
struct BoundingBoxes {
    double node_cost = 1;
    double group_cost = 1;

    static const ItemInfo vocabulary;
};
/// Every index there is; the first one is the default.
using RayIndex = std::variant<KdTree, BoundingBoxes>;

/// How a tree is built by the index, over items of which so many are tested at once.
TreeSettings tree_settings(const RayIndex&, int group = 8);

}  // namespace candelabra
