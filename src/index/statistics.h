// SPDX-License-Identifier: GPL-3.0-or-later
// What a built index looks like, as values: for --stats, reports, tests and benchmarks.
#pragma once

#include "index/kdtree.h"

#include <cstddef>

struct KdTreeStatistics {
    std::size_t nodes = 0;   ///< inner nodes and leaves
    std::size_t leaves = 0;  ///< with or without items
    std::size_t empty_leaves = 0;
    int max_depth = 0;  ///< of a leaf; 0 when the root is one
    std::size_t max_items_per_leaf = 0;
    double mean_items_per_leaf = 0;  ///< over the leaves that have items
    double duplication = 0;          ///< leaves per item, over the items that are in any
    double cost = 0;  ///< expected cost of a ray that meets the bounds, in the settings' unit
    std::size_t bytes = 0;
};

KdTreeStatistics statistics(const KdTree&);
