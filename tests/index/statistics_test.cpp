// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/statistics.h"

#include "items.h"

#include <catch2/catch.hpp>

TEST_CASE("an empty kd-tree has nothing to count", "[index]") {
    const KdTreeStatistics s = statistics(KdTree());
    CHECK(s.nodes == 0);
    CHECK(s.leaves == 0);
    CHECK(s.cost == 0);
    CHECK(s.duplication == 0);
    CHECK(s.bytes == sizeof(KdTree));
}

TEST_CASE("a kd-tree of one leaf", "[index]") {
    const KdTree tree =
        build_kdtree(std::vector<Box>(5, Box{Vec3(0), Vec3(1)}), {}, {.intersection_cost = 3});
    const KdTreeStatistics s = statistics(tree);
    CHECK(s.nodes == 1);
    CHECK(s.leaves == 1);
    CHECK(s.empty_leaves == 0);
    CHECK(s.max_depth == 0);
    CHECK(s.max_items_per_leaf == 5);
    CHECK(s.mean_items_per_leaf == 5);
    CHECK(s.duplication == 1);
    CHECK(s.cost == Approx(15));
}

TEST_CASE("the counts of a kd-tree agree with each other", "[index]") {
    for (const ItemScene& scene : scenes()) {
        CAPTURE(scene.name);
        const KdTree tree = tree_of(scene.items);
        const KdTreeStatistics s = statistics(tree);
        const auto references = static_cast<double>(tree.items().size());
        CHECK(s.nodes == tree.nodes().size());
        CHECK(s.nodes == 2 * s.leaves - 1);
        CHECK(s.empty_leaves < s.leaves);
        CHECK(s.mean_items_per_leaf * static_cast<double>(s.leaves - s.empty_leaves) ==
              Approx(references));
        CHECK(s.mean_items_per_leaf <= static_cast<double>(s.max_items_per_leaf));
        CHECK(s.duplication * static_cast<double>(scene.items.size()) == Approx(references));
        CHECK(s.max_depth <= 8 + 1.3 * std::log2(static_cast<double>(scene.items.size())));
        CHECK(s.bytes >= s.nodes * sizeof(KdNode) + tree.items().size() * sizeof(std::uint32_t));
        // The heuristic never makes a tree that it expects to cost more than one leaf.
        CHECK(s.cost <=
              tree.settings().intersection_cost * static_cast<double>(scene.items.size()) * 1.0001);
    }
}

TEST_CASE("division pays: a ray through many items expects to test few", "[index]") {
    const KdTreeStatistics s = statistics(tree_of(random_balls(10000, 0.005, 0.02, 1)));
    CHECK(s.cost < 100);
    CHECK(s.duplication < 4);
    CHECK(s.max_depth > 8);
}
