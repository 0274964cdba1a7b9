// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of each ray index: part of the scene, chosen by global_settings { index ... } or
// --index. Both indices build a WideTree, so traversal is the same.
#pragma once

#include "index/wide_tree.h"
#include "vocabulary/kinds.h"

namespace candelabra {

/// Divides space by planes into cells that do not overlap. Items are in all cells through which
/// they pass (Bentley, "Multidimensional Binary Search Trees Used for Associative Searching",
/// 1975).
struct KdTree {
    double node_cost = 0.5;
    double group_cost = 1;
    double reference_cost = 0.2;

    static const ItemInfo vocabulary;
};
/// Divides items into groups, whose boxes may overlap.
struct BoundingBoxes {
    double node_cost = 1;
    double group_cost = 1;

    static const ItemInfo vocabulary;
};
/// All indices; the first one is the default.
using RayIndex = std::variant<KdTree, BoundingBoxes>;

/// Returns the build settings of the index, for items that are tested in groups of this size.
TreeSettings tree_settings(const RayIndex&, int group = 8);

}  // namespace candelabra
