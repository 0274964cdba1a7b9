// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/statistics.h"

#include <algorithm>
#include <vector>

namespace {

struct Place {
    std::size_t node;
    Box cell;
    int depth;
};

void count_leaf(std::size_t items, int depth, KdTreeStatistics& result) {
    ++result.leaves;
    result.empty_leaves += items == 0;
    result.max_depth = std::max(result.max_depth, depth);
    result.max_items_per_leaf = std::max(result.max_items_per_leaf, items);
}

std::size_t distinct(std::span<const std::uint32_t> items) {
    std::vector<std::uint32_t> sorted(items.begin(), items.end());
    std::sort(sorted.begin(), sorted.end());
    return static_cast<std::size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
}

}  // namespace

KdTreeStatistics statistics(const KdTree& tree) {
    KdTreeStatistics result;
    result.bytes = tree.memory_bytes();
    result.nodes = tree.nodes().size();
    if (tree.nodes().empty()) return result;

    // A cell without area is met with certainty by a ray that meets the bounds: they have none
    // either.
    const double whole = area(tree.bounds());
    std::vector<Place> todo{{0, tree.bounds(), 0}};
    while (!todo.empty()) {
        const Place place = todo.back();
        todo.pop_back();
        const KdNode& node = tree.nodes()[place.node];
        const double chance = whole > 0 ? area(place.cell) / whole : 1;
        if (node.is_leaf()) {
            count_leaf(node.item_count(), place.depth, result);
            result.cost += chance * tree.settings().intersection_cost * node.item_count();
            continue;
        }
        result.cost += chance * tree.settings().traversal_cost;
        const int axis = static_cast<int>(node.axis());
        Box below = place.cell;
        Box above = place.cell;
        below.high[axis] = node.plane();
        above.low[axis] = node.plane();
        todo.push_back({node.first_child(), below, place.depth + 1});
        todo.push_back({node.first_child() + 1, above, place.depth + 1});
    }
    const std::size_t full = result.leaves - result.empty_leaves;
    const auto references = static_cast<double>(tree.items().size());
    if (full > 0) {
        result.mean_items_per_leaf = references / static_cast<double>(full);
        result.duplication = references / static_cast<double>(distinct(tree.items()));
    }
    return result;
}
