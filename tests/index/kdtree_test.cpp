// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/kdtree.h"

#include "index/brute.h"
#include "items.h"

#include <oneapi/tbb/global_control.h>
#include <catch2/catch.hpp>

#include <algorithm>

namespace {

/// A length from 1e-3 to 1e3: t is measured in it.
Vec3 stretched(Random& random, const Vec3& v) { return v * std::pow(10, uniform(random, -3, 3)); }

/// The box's size, or the scene's where the item is a point.
double size_of(const Item& item, const Box& bounds) {
    const double size = max_component(item.box.size());
    return size > 0 ? size : max_component(bounds.size());
}

Ray random_ray(Random& random, const std::vector<Item>&, const KdTree& tree) {
    const Vec3 size = tree.bounds().size();
    const Vec3 origin = point_in(random, {tree.bounds().low - size, tree.bounds().high + size});
    return {origin, stretched(random, unit(point_in(random, tree.bounds()) - origin))};
}

/// Touches an item, as nearly as doubles allow: a ball's tangent, or a line through a box's corner
/// or edge.
Ray grazing_ray(Random& random, const std::vector<Item>& items, const KdTree& tree) {
    const Item& item = items[random() % items.size()];
    const Vec3 normal = direction(random);
    const Vec3 along = unit(cross(normal, direction(random)));
    Vec3 point = item.centre() + item.radius * normal;
    if (item.radius <= 0) {
        point = point_in(random, item.box);
        for (int axis = 0; axis < 3; ++axis) {
            if (random() % 3 != 0)
                point[axis] = random() % 2 ? item.box.low[axis] : item.box.high[axis];
        }
    }
    return {point - along * size_of(item, tree.bounds()) * uniform(random, 0, 3),
            stretched(random, along)};
}

/// Runs along an axis, with other coordinates that are those of items or of the tree's planes, and
/// zeros of both signs.
Ray axis_ray(Random& random, const std::vector<Item>& items, const KdTree& tree) {
    const Item& item = items[random() % items.size()];
    Ray ray{point_in(random, item.box), Vec3(0)};
    for (int axis = 0; axis < 3; ++axis) {
        const KdNode& node = tree.nodes()[random() % tree.nodes().size()];
        const auto choice = random() % 5;
        if (choice == 0) ray.origin[axis] = item.box.low[axis];
        if (choice == 1) ray.origin[axis] = item.box.high[axis];
        if (choice == 2) ray.origin[axis] = item.centre()[axis];
        if (choice == 3 && !node.is_leaf() && static_cast<int>(node.axis()) == axis)
            ray.origin[axis] = node.plane();
        ray.direction[axis] = random() % 2 ? 0.0 : -0.0;
    }
    const auto axis = static_cast<int>(random() % 3);
    const double sign = random() % 2 ? 1 : -1;
    ray.direction[axis] = sign * std::pow(10, uniform(random, -3, 3));
    if (random() % 2)
        ray.origin[axis] -= sign * uniform(random, 0, 2) * max_component(tree.bounds().size());
    return ray;
}

/// Starts in an item's box or on its surface.
Ray inner_ray(Random& random, const std::vector<Item>& items, const KdTree&) {
    const Item& item = items[random() % items.size()];
    const Vec3 on_surface = item.centre() + item.radius * direction(random);
    const Vec3 origin = random() % 2 && item.radius > 0 ? on_surface : point_in(random, item.box);
    return {origin, stretched(random, direction(random))};
}

struct RayKind {
    const char* name;
    Ray (*make)(Random&, const std::vector<Item>&, const KdTree&);
};

constexpr RayKind ray_kinds[] = {{"random", random_ray},
                                 {"grazing", grazing_ray},
                                 {"along an axis", axis_ray},
                                 {"from inside", inner_ray}};

/// The rays, of `count`, for which the two indices disagree on the first or on any hit.
int disagreements(const KdTree& tree, const std::vector<Item>& items, const RayKind& kind,
                  int count) {
    const BruteForce brute(items.size());
    Random random(11);
    int result = 0;
    for (int i = 0; i < count; ++i) {
        const Ray ray = kind.make(random, items, tree);
        const ItemHit expected = first_hit(brute, items, ray);
        const double end = expected.t < no_hit ? expected.t * uniform(random, 0.5, 2) : no_hit;
        const Interval part{random() % 2 ? 0 : end * 0.25, end};
        const bool agree =
            first_hit(tree, items, ray) == expected &&
            first_hit(tree, items, ray, part) == first_hit(brute, items, ray, part) &&
            any_hit(tree, items, ray, part) == any_hit(brute, items, ray, part);
        result += !agree;
    }
    return result;
}

bool same(const KdTree& a, const KdTree& b) {
    return std::ranges::equal(a.nodes(), b.nodes()) && std::ranges::equal(a.items(), b.items()) &&
           a.bounds().low == b.bounds().low && a.bounds().high == b.bounds().high;
}

constexpr auto never = [](std::span<const std::uint32_t>, Interval&) { return true; };

}  // namespace

TEST_CASE("the kd-tree finds the hits that brute force finds", "[index]") {
    for (const ItemScene& scene : scenes()) {
        const KdTree tree = tree_of(scene.items);
        for (const RayKind& kind : ray_kinds) {
            CAPTURE(scene.name, kind.name);
            CHECK(disagreements(tree, scene.items, kind, 4000) == 0);
        }
    }
}

TEST_CASE("hits do not depend on the settings of the build", "[index]") {
    const std::vector<Item> items = random_balls(300, 0.02, 0.3, 12);
    const KdTreeSettings cases[] = {
        {.max_depth = 3},
        {.leaf_size = 20},
        {.leaf_size = 0},
        {.leaf_size = -1},
        {.empty_bonus = 0},
        {.empty_bonus = 1},
        {.max_depth = 1000},
        {.intersection_cost = 50},
        {.traversal_cost = 0, .empty_bonus = 0.9},
        {.max_duplication = 1},
    };
    for (const KdTreeSettings& settings : cases) {
        const KdTree tree = tree_of(items, settings);
        for (const RayKind& kind : ray_kinds) CHECK(disagreements(tree, items, kind, 500) == 0);
    }
}

TEST_CASE("without a clip function boxes are clipped", "[index]") {
    const std::vector<Item> items = flat_boxes(200, 13);
    const KdTree tree = build_kdtree(boxes_of(items), {}, {}, 1);
    for (const RayKind& kind : ray_kinds) CHECK(disagreements(tree, items, kind, 1000) == 0);
}

TEST_CASE("the kd-tree is the same for any number of threads", "[index]") {
    // Otherwise no more threads would start than there are cores.
    const oneapi::tbb::global_control allowed(oneapi::tbb::global_control::max_allowed_parallelism,
                                              7);
    const std::vector<Item> items = random_balls(20000, 0.005, 0.05, 14);
    const KdTree one = tree_of(items, {}, 1);
    REQUIRE(one.nodes().size() > 5000);
    for (const int threads : {0, 2, 7}) CHECK(same(one, tree_of(items, {}, threads)));
}

TEST_CASE("an empty kd-tree visits nothing", "[index]") {
    const std::vector<Box> only_empty(3);
    for (const KdTree& tree : {KdTree(), build_kdtree({}, {}), build_kdtree(only_empty, {})}) {
        CHECK(tree.bounds().empty());
        CHECK_FALSE(tree.traverse({Vec3(0), Vec3(0, 0, 1)}, {}, never));
    }
}

TEST_CASE("items with empty boxes are left out", "[index]") {
    const std::vector<Box> boxes = {{}, {Vec3(0), Vec3(1)}, {}};
    const KdTree tree = build_kdtree(boxes, {});
    CHECK(std::ranges::equal(tree.items(), std::vector<std::uint32_t>{1}));
}

TEST_CASE("rays that cannot meet anything visit nothing", "[index]") {
    const KdTree tree = build_kdtree(std::vector<Box>{{Vec3(0), Vec3(1)}}, {});
    struct Case {
        Ray ray;
        Interval range;
    };
    const Case cases[] = {
        {{Vec3(2, 2, 2), Vec3(1, 0, 0)}, {}},
        {{Vec3(-1, 0.5, 0.5), Vec3(-1, 0, 0)}, {}},
        {{Vec3(-1, 0.5, 0.5), Vec3(1, 0, 0)}, {0, 0.9}},
        {{Vec3(-1, 0.5, 0.5), Vec3(1, 0, 0)}, {2.1, 5}},
        {{Vec3(0.5), Vec3(1, 0, 0)}, {5, 1}},
        {{Vec3(2), Vec3(0)}, {}},
    };
    for (const Case& c : cases) CHECK_FALSE(tree.traverse(c.ray, c.range, never));
}

TEST_CASE("leaves are visited front to back until the hit, or until told to stop", "[index]") {
    std::vector<Item> row;
    for (int i = 0; i < 1000; ++i) row.push_back(ball(Vec3(i, 0, 0), 0.3));
    const KdTree tree = tree_of(row);
    const Ray ray{Vec3(1000, 0.1, 0), Vec3(-2, 0, 0)};

    int leaves = 0;
    std::uint32_t last = 1000;
    bool ordered = true;
    const auto look = [&](std::span<const std::uint32_t> items, Interval&) {
        ++leaves;
        ordered = ordered && items.front() <= last;
        last = items.front();
        return false;
    };
    CHECK_FALSE(tree.traverse(ray, {}, look));
    CHECK(ordered);
    CHECK(leaves >= 100);

    leaves = 0;
    tree.traverse(ray, {}, [&](std::span<const std::uint32_t> items, Interval& range) {
        ++leaves;
        for (const std::uint32_t i : items)
            range.max = std::min(range.max, meet(row[i], ray, range));
        return false;
    });
    CHECK(leaves <= 2);

    leaves = 0;
    CHECK(tree.traverse(ray, {},
                        [&](std::span<const std::uint32_t>, Interval&) { return ++leaves == 3; }));
    CHECK(leaves == 3);
}

TEST_CASE("a million coincident items make one leaf", "[index]") {
    const std::vector<Box> boxes(1000000, Box{Vec3(-1), Vec3(1)});
    const KdTree tree = build_kdtree(boxes, {});
    CHECK(tree.items().size() == boxes.size());
    CHECK(tree.nodes().size() == 1);
}

TEST_CASE("long thin items do not multiply without bound", "[index]") {
    Random random(15);
    std::vector<Ray> needles;
    std::vector<Box> boxes;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = point_in(random, {Vec3(0), Vec3(1)});
        const Vec3 b = point_in(random, {Vec3(0), Vec3(1)});
        needles.push_back({a, b - a});
        boxes.push_back({glm::min(a, b), glm::max(a, b)});
    }
    const auto part = [&](std::uint32_t i, const Box& cell) {
        const Interval inside = clip(needles[i], cell, {0, 1});
        if (!(inside.min <= inside.max)) return Box{};
        return join(Box{needles[i].at(inside.min), needles[i].at(inside.min)},
                    needles[i].at(inside.max));
    };
    const std::size_t free = build_kdtree(boxes, part).items().size();
    const std::size_t bound = build_kdtree(boxes, part, {.max_duplication = 3}).items().size();
    CHECK(free > 8 * boxes.size());
    CHECK(bound < 6 * boxes.size());
}

TEST_CASE("the tree's span of items holds each leaf's", "[index]") {
    const std::vector<Item> items = random_balls(100, 0.05, 0.2, 16);
    const KdTree tree = tree_of(items);
    const Ray ray{Vec3(-2, 0.1, 0.2), Vec3(1, 0, 0)};
    tree.traverse(ray, {}, [&](std::span<const std::uint32_t> leaf, Interval&) {
        CHECK(leaf.data() >= tree.items().data());
        CHECK(leaf.data() + leaf.size() <= tree.items().data() + tree.items().size());
        CHECK(std::ranges::is_sorted(leaf));
        return false;
    });
}

TEST_CASE("rays that ask for anything in their way pass the same leaves, the likely ones first",
          "[index]") {
    // Crumbs between the origin and a wall.
    std::vector<Item> items = random_balls(400, 0.001, 0.01, 21);
    items.push_back({{Vec3(2, -1, -1), Vec3(2.1, 1, 1)}});
    const KdTree tree = tree_of(items, {.leaf_size = 0});
    const Ray ray{Vec3(-2, 0.1, 0.2), Vec3(1, 0, 0)};
    std::vector<const std::uint32_t*> near, likely;
    const auto note = [](std::vector<const std::uint32_t*>& leaves) {
        return [&](std::span<const std::uint32_t> leaf, Interval&) {
            leaves.push_back(leaf.data());
            return false;
        };
    };
    CHECK_FALSE(tree.traverse(ray, {0, 5}, note(near)));
    CHECK_FALSE(tree.traverse_likely(ray, {0, 5}, note(likely)));
    REQUIRE(near.size() > 5);
    CHECK(near.back() == likely.front());
    CHECK(near != likely);
    std::ranges::sort(near);
    std::ranges::sort(likely);
    CHECK(near == likely);
}
