// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/tree_builder.h"

#include "index/statistics.h"
#include "items.h"

#include <oneapi/tbb/global_control.h>
#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

bool same(const WideTree& a, const WideTree& b) {
    return std::ranges::equal(a.nodes(), b.nodes()) && std::ranges::equal(a.frames(), b.frames()) &&
           std::ranges::equal(a.early_occluders(), b.early_occluders()) &&
           items_of(a) == items_of(b);
}

}  // namespace

TEST_CASE("the tree is the same for any number of threads", "[index]") {
    // Otherwise at most as many threads as cores would start.
    const oneapi::tbb::global_control allowed(oneapi::tbb::global_control::max_allowed_parallelism,
                                              7);
    const std::vector<Item> items = random_balls(20000, 0.005, 0.05, 14);
    for (const TreeSettings& settings : both_divisions) {
        const WideTree one = tree_of(items, settings, 1);
        REQUIRE(one.nodes().size() > 500);
        for (const int threads : {0, 2, 7}) CHECK(same(one, tree_of(items, settings, threads)));
    }
}

TEST_CASE("items with empty boxes are left out", "[index]") {
    const std::vector<Box> boxes = {{}, {Vec3(0), Vec3(1)}, {}};
    for (const TreeSettings& settings : both_divisions)
        CHECK(items_of(build_tree(boxes, settings)) == std::vector<std::uint32_t>{1});
}

TEST_CASE("items without end are visited by every ray", "[index]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Box> endless = {everywhere(),
                                      {Vec3(-1e308), Vec3(1e308)},
                                      {Vec3(nan), Vec3(nan)},
                                      {Vec3(0, 0, -infinity), Vec3(1, 1, 0)}};
    const TreeSettings settings = GENERATE(from_range(both_divisions));
    for (const int others : {0, 1, 40}) {
        std::vector<Box> boxes;
        for (int i = 0; i < others; ++i) boxes.push_back({Vec3(i), Vec3(i + 0.5)});
        for (int i = 0; i < 10; ++i) boxes.push_back(endless[static_cast<std::size_t>(i) % 4]);
        const WideTree tree = build_tree(boxes, settings);
        REQUIRE(tree.endless().size() == 10);
        CHECK(tree.endless()[0] == static_cast<std::uint32_t>(others));
        CHECK(items_of(tree).size() == static_cast<std::size_t>(others));
        CHECK(tree.bounds().empty() == (others == 0));
        std::size_t visited = 0;
        const auto count = [&](std::span<const std::uint32_t> items, Interval&) {
            CHECK(items.size() <= 8);
            // Early occluders are visited even by rays that miss them.
            visited += static_cast<std::size_t>(std::ranges::count_if(
                items, [&](std::uint32_t i) { return i >= static_cast<std::uint32_t>(others); }));
            return false;
        };
        const Ray past{Vec3(-5), Vec3(0, 1, 0)};
        tree.traverse(past, {}, count);
        CHECK(visited == 10);
        visited = 0;
        tree.traverse_likely(past, {}, count);
        CHECK(visited == 10);
    }
}

TEST_CASE("a million coincident items are all there, and not deep", "[index]") {
    const std::vector<Box> boxes(1000000, Box{Vec3(-1), Vec3(1)});
    const WideTree tree = build_tree(boxes, GENERATE(from_range(both_divisions)));
    CHECK(items_of(tree).size() == boxes.size());
    CHECK(statistics(tree).max_depth < 10);
    CHECK(tree.memory_bytes() < 50 * boxes.size());
}

TEST_CASE("items of a leaf are in order", "[index]") {
    const std::vector<Item> items = random_balls(1000, 0.05, 0.2, 16);
    const WideTree tree = tree_of(items, GENERATE(from_range(both_divisions)));
    tree.traverse({Vec3(-2, 0.1, 0.2), Vec3(1, 0, 0)}, {},
                  [&](std::span<const std::uint32_t> leaf, Interval&) {
                      CHECK(leaf.size() <= 8);
                      CHECK(std::ranges::is_sorted(leaf));
                      return false;
                  });
}

TEST_CASE("what is large among many is asked before all others", "[index]") {
    std::vector<Item> items = random_balls(2000, 0.001, 0.01, 41);
    CHECK(tree_of(items).early_occluders().empty());
    items.push_back(ball(Vec3(0), 0.5));
    items.push_back(ball(Vec3(0.3), 0.6));
    const WideTree tree = tree_of(items, GENERATE(from_range(both_divisions)));
    REQUIRE(tree.early_occluders().size() == 1);
    CHECK(std::ranges::equal(tree.items(tree.early_occluders()[0]),
                             std::vector<std::uint32_t>{2000, 2001}));
    // The early occluder is in the tree as well.
    CHECK(std::ranges::count(different_items_of(tree), 2000u) == 1);
}

TEST_CASE("cells of the kd-tree do not overlap, and boxes of items in them fill no more",
          "[index]") {
    const std::vector<Item> items = random_balls(2000, 0.005, 0.05, 42);
    const WideTree tree = tree_of(items, tree_settings(KdTree()));
    Random random(43);
    int twice = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 point = point_in(random, tree.bounds());
        int cells = 0;
        tree.for_each_node([&](std::uint32_t number, const TreeFrame& frame, int) {
            const TreeNode& node = tree.nodes()[number];
            for (std::size_t slot = 0; slot < TreeNode::width; ++slot)
                cells += node.used(slot) && node.children[slot].is_leaf() &&
                         contains(node.box(slot, frame.origin), point);
        });
        twice += cells > 1;
    }
    // Where planes cannot separate items, a cell has more than eight of them.
    CHECK(twice < 200);
}

TEST_CASE("the kd-tree has an item in every cell that its surface passes through", "[index]") {
    const std::vector<Item> items = random_balls(1000, 0.05, 0.5, 44);
    const WideTree tree = tree_of(items, tree_settings(KdTree()));
    CHECK(items_of(tree).size() > items.size());
    Random random(45);
    for (int i = 0; i < 2000; ++i) {
        const auto number = static_cast<std::uint32_t>(random() % items.size());
        const Vec3 point = items[number].centre() + items[number].radius * direction(random);
        const bool found = tree.traverse({point, Vec3(1)}, {0, 0},
                                         [&](std::span<const std::uint32_t> leaf, Interval&) {
                                             return std::ranges::count(leaf, number) > 0;
                                         });
        CHECK(found);
    }
}

TEST_CASE("what touches stands in one cell of the kd-tree", "[index]") {
    for (const std::vector<Item>& items : {touching_boxes(8), touching_balls(8)})
        CHECK(items_of(tree_of(items, tree_settings(KdTree()))).size() == items.size());
}

TEST_CASE("items that fill all cells have a bounded number of references", "[index]") {
    Random random(46);
    std::vector<Item> items;
    for (int i = 0; i < 3000; ++i) {
        Box box = {Vec3(-1), Vec3(1)};
        const auto axis = static_cast<int>(random() % 3);
        box.low[axis] = uniform(random, -1, 0);
        box.high[axis] = uniform(random, 0, 1);
        items.push_back({box});
    }
    const WideTree tree = tree_of(items, tree_settings(KdTree()));
    CHECK(items_of(tree).size() <= 8 * items.size() + 8);
    CHECK(different_items_of(tree).size() == items.size());
}

}  // namespace candelabra
