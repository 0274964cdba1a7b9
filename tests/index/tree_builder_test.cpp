// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/tree_builder.h"

#include "index/statistics.h"
#include "items.h"
#include "shape/triangle.h"

#include <oneapi/tbb/global_control.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace candelabra {

namespace {

bool same(const WideTree& a, const WideTree& b) {
    return std::ranges::equal(a.nodes(), b.nodes()) && std::ranges::equal(a.frames(), b.frames()) &&
           std::ranges::equal(a.early_occluders(), b.early_occluders()) &&
           items_of(a) == items_of(b);
}

/// A tree of triangles, and how often it asked for a part of one.
struct CountedTree {
    WideTree tree;
    std::size_t parts = 0;
};

CountedTree counted_tree(const std::vector<Triangle>& faces, const TreeSettings& settings) {
    CountedTree made;
    made.tree = build_tree(
        static_cast<std::uint32_t>(faces.size()),
        [&](std::uint32_t item) { return bounds(faces[item]); },
        [&](std::uint32_t item, const Box& cell) {
            ++made.parts;
            return clipped_bounds(faces[item], cell);
        },
        settings, 1);
    return made;
}

/// Triangles of many sizes in planes across z, of which `planes` are `apart` from each other.
std::vector<Triangle> in_planes(int count, int planes, double apart) {
    Random random(61);
    std::vector<Triangle> faces;
    for (int i = 0; i < count; ++i) {
        const Vec3 at = point_in(random, {Vec3(-1), Vec3(1)});
        const double size = std::pow(10, uniform(random, -3, 0));
        Triangle face{at, at + size * direction(random), at + size * direction(random)};
        face.corner1.z = face.corner2.z = face.corner3.z = i % planes * apart - 10.56;
        faces.push_back(face);
    }
    return faces;
}

/// A square, and a ring of thin triangles at that height above it.
std::vector<Triangle> ring_above_square(double height) {
    std::vector<Triangle> faces{{Vec3(0.8, 1.6, 0), Vec3(-0.8, 1.6, 0), Vec3(0.8, -1.6, 0)}};
    for (int i = 0; i < 11; ++i) {
        const auto at = [&](int step, double radius) {
            const double angle = step * 0.39269908169872414;
            return Vec3(radius * std::cos(angle), radius * std::sin(angle), height);
        };
        faces.push_back({at(i, 0.32), at(i + 1, 0.32), at(i, 0.24)});
    }
    for (Triangle& face : faces)
        for (Vec3* corner : {&face.corner1, &face.corner2, &face.corner3}) corner->z -= 10.56;
    return faces;
}

std::vector<Triangle> needles(int count, double width, double around) {
    Random random(62);
    std::vector<Triangle> faces;
    for (int i = 0; i < count; ++i) {
        const Vec3 from = around * point_in(random, {Vec3(-1), Vec3(1)});
        const Vec3 to = point_in(random, {Vec3(-1), Vec3(1)});
        faces.push_back({from, to, to + width * direction(random)});
    }
    return faces;
}

/// Corners on a lattice of neighbouring doubles: all of them are within the tolerance.
std::vector<Triangle> within_rounding(int count) {
    Random random(63);
    const auto corner = [&] {
        const auto step = [&] { return static_cast<double>(random() % 40) * 0x1p-52; };
        const double x = step(), y = step();
        return Vec3(1) + Vec3(x, y, step());
    };
    std::vector<Triangle> faces;
    for (int i = 0; i < count; ++i) {
        const Vec3 a = corner(), b = corner();
        faces.push_back({a, b, corner()});
    }
    return faces;
}

std::vector<Triangle> nested_pyramids(int count) {
    std::vector<Triangle> faces;
    for (int i = 0; i < count; ++i) {
        const double size = std::pow(10, -12 + 13.0 * i / count);
        const Vec3 x(size, 0, 0), y(0, size, 0), z(0, 0, size);
        faces.insert(faces.end(), {{x, y, z}, {Vec3(0), x, y}, {Vec3(0), y, z}, {Vec3(0), z, x}});
    }
    return faces;
}

/// A height field: smooth, in steps, or rough.
std::vector<Triangle> heights(int side, const std::function<double(double, double)>& height) {
    std::vector<Triangle> faces;
    const auto at = [&](int x, int y) {
        const double u = static_cast<double>(x) / side, v = static_cast<double>(y) / side;
        return Vec3(u, height(u, v), v);
    };
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y) {
            faces.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
            faces.push_back({at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    return faces;
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

TEST_CASE("every build ends after work in proportion to the items", "[index]") {
    std::vector<std::vector<Triangle>> families;
    for (const double apart : {0.0, 0x1p-49, 1e-14, 1e-13, 1e-12, 1e-10, 1e-7, 1e-4}) {
        families.push_back(ring_above_square(apart));
        for (const int planes : {2, 7}) families.push_back(in_planes(2000, planes, apart));
    }
    for (const double width : {1e-2, 1e-5, 1e-9, 1e-13, 0.0}) {
        families.push_back(needles(2000, width, 1));
        families.push_back(needles(2000, width, 0));
    }
    families.emplace_back(2000, Triangle{Vec3(0.1, 0.2, 0.3), Vec3(1, 0, 0.5), Vec3(0, 1, 0.7)});
    families.push_back(within_rounding(2000));
    families.push_back(nested_pyramids(500));
    families.push_back(heights(32, [](double u, double v) { return std::sin(9 * u) * v; }));
    families.push_back(heights(32, [](double u, double v) { return std::floor(8 * u * v) / 8; }));
    families.push_back(heights(32, [](double u, double v) {
        return 0.3 * std::fmod(1e4 * std::sin(12.9898 * u + 78.233 * v), 1);
    }));
    for (const std::vector<Triangle>& faces : families)
        for (const TreeSettings& settings : both_divisions) {
            const CountedTree made = counted_tree(faces, settings);
            CHECK(different_items_of(made.tree).size() == faces.size());
            CHECK(items_of(made.tree).size() <= 16 * faces.size());
            CHECK(made.parts <= 32 * faces.size());
            CHECK(made.tree.nodes().size() <= faces.size());
        }
}

TEST_CASE("spheres of one surface and nested ones are built in proportion to their number",
          "[index]") {
    std::vector<Item> same(2000, ball(Vec3(1, 2, 3), 1)), few, nested, tiny;
    for (int i = 0; i < 2000; ++i) {
        few.push_back(ball(Vec3(0.1 * (i % 10), 0, 0), 0.5 + 0.03 * (i % 7)));
        nested.push_back(ball(Vec3(0.3, 0, 0), 1 + i));
        tiny.push_back(ball(Vec3(0.3, 0, 0), std::pow(10, -12 + 0.0065 * i)));
    }
    for (const std::vector<Item>& items : {same, few, nested, tiny}) {
        std::size_t parts = 0;
        const WideTree tree = build_tree(
            static_cast<std::uint32_t>(items.size()),
            [&](std::uint32_t item) { return items[item].box; },
            [&](std::uint32_t item, const Box& cell) {
                ++parts;
                return part_of(items[item], cell);
            },
            tree_settings(KdTree()), 1);
        CHECK(different_items_of(tree).size() == items.size());
        CHECK(items_of(tree).size() <= 16 * items.size());
        CHECK(parts <= 32 * items.size());
    }
}

}  // namespace candelabra
