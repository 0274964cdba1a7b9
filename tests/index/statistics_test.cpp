// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/statistics.h"

#include "items.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("an empty hierarchy has nothing to count", "[index]") {
    const TreeStatistics s = statistics(WideTree());
    CHECK(s.nodes == 0);
    CHECK(s.leaves == 0);
    CHECK(s.cost == 0);
    CHECK(s.mean_items_per_leaf == 0);
    CHECK(s.bytes == sizeof(WideTree));
}

TEST_CASE("a hierarchy of one leaf", "[index]") {
    const WideTree tree =
        build_tree(std::vector<Box>(5, Box{Vec3(0), Vec3(1)}), {.node_cost = 2, .group_cost = 3});
    const TreeStatistics s = statistics(tree);
    CHECK(s.nodes == 1);
    CHECK(s.frames == 1);
    CHECK(s.leaves == 1);
    CHECK(s.max_depth == 1);
    CHECK(s.max_items_per_leaf == 5);
    CHECK(s.mean_items_per_leaf == 5);
    CHECK(s.cost == Approx(2 + 3 * 0.5 * (5 / 8.0 + 1)));
}

TEST_CASE("the counts of a hierarchy agree with each other", "[index]") {
    for (const ItemScene& scene : scenes()) {
        CAPTURE(scene.name);
        const WideTree tree = tree_of(scene.items);
        const TreeStatistics s = statistics(tree);
        CHECK(s.nodes == tree.nodes().size());
        CHECK(s.frames == tree.frames().size());
        CHECK(s.mean_items_per_leaf * static_cast<double>(s.leaves) ==
              Approx(static_cast<double>(scene.items.size())));
        CHECK(s.mean_items_per_leaf <= static_cast<double>(s.max_items_per_leaf));
        CHECK(s.max_depth <= WideTree::depth_limit);
        CHECK(s.bytes >= s.nodes * sizeof(TreeNode) + scene.items.size() * sizeof(std::uint32_t));
    }
}

TEST_CASE("division pays: a ray through many items expects to test few", "[index]") {
    const TreeStatistics s = statistics(tree_of(random_balls(10000, 0.005, 0.02, 1)));
    CHECK(s.cost < 40);
    CHECK(s.max_depth >= 4);
    CHECK(s.mean_items_per_leaf > 3);
}

}  // namespace candelabra
