// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/statistics.h"

#include "index/split.h"

#include <algorithm>

namespace candelabra {

TreeStatistics statistics(const WideTree& tree) {
    TreeStatistics result;
    result.bytes = tree.memory_bytes();
    result.nodes = tree.nodes().size();
    result.frames = tree.frames().size();
    const TreeSettings& costs = tree.settings();
    // A box without area counts as met with certainty: then the bounds have no area either.
    const double whole = area(tree.bounds());
    const auto chance = [&](const Box& box) {
        return whole > 0 ? std::min(1.0, area(box) / whole) : 1;
    };
    if (result.nodes > 0) result.cost = costs.node_cost;
    tree.for_each_node([&](std::uint32_t number, const TreeFrame& frame, int level) {
        const TreeNode& node = tree.nodes()[number];
        result.max_depth = std::max(result.max_depth, level);
        for (std::size_t slot = 0; slot < TreeNode::width; ++slot) {
            if (!node.used(slot)) continue;
            const TreeChild child = node.children[slot];
            const double met = chance(node.box(slot, frame.origin));
            if (!child.is_leaf()) {
                result.cost += met * costs.node_cost;
                continue;
            }
            const std::size_t count = tree.items(child).size();
            ++result.leaves;
            result.references += count;
            result.max_items_per_leaf = std::max(result.max_items_per_leaf, count);
            result.cost += met * cost_of_items(static_cast<double>(count), costs);
        }
    });
    if (result.leaves > 0)
        result.mean_items_per_leaf =
            static_cast<double>(result.references) / static_cast<double>(result.leaves);
    return result;
}

}  // namespace candelabra
