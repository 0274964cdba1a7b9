// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of a built index: for --stats, reports, tests and benchmarks.
#pragma once

#include "index/wide_tree.h"

#include <cstddef>

namespace candelabra {

struct TreeStatistics {
    std::size_t nodes = 0;
    std::size_t frames = 0;  ///< see TreeFrame
    std::size_t leaves = 0;
    int max_depth = 0;  ///< levels of nodes
    std::size_t max_items_per_leaf = 0;
    std::size_t references = 0;  ///< sum of the items of all leaves
    double mean_items_per_leaf = 0;
    double cost = 0;  ///< expected cost of a ray that meets the bounds, in the unit of the settings
    std::size_t bytes = 0;
};

TreeStatistics statistics(const WideTree&);

}  // namespace candelabra
