// SPDX-License-Identifier: GPL-3.0-or-later
// What a built index looks like, as values: for --stats, reports, tests and benchmarks.
#pragma once

#include "index/bvh.h"

#include <cstddef>

struct BvhStatistics {
    std::size_t nodes = 0;
    std::size_t frames = 0;  ///< see BvhFrame
    std::size_t leaves = 0;
    int max_depth = 0;  ///< levels of nodes
    std::size_t max_items_per_leaf = 0;
    double mean_items_per_leaf = 0;
    double cost = 0;  ///< expected cost of a ray that meets the bounds, in the settings' unit
    std::size_t bytes = 0;
};

BvhStatistics statistics(const Bvh&);
