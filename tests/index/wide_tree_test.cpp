// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/wide_tree.h"

#include "index/brute.h"
#include "index/statistics.h"
#include "items.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

/// Scales a direction by 1e-3 to 1e3; t is in units of its length.
Vec3 stretched(Random& random, const Vec3& v) { return v * std::pow(10, uniform(random, -3, 3)); }

/// The size of the item's box, or of the scene's if the item is a point.
double size_of(const Item& item, const Box& bounds) {
    const double size = max_component(item.box.size());
    return size > 0 ? size : max_component(bounds.size());
}

Ray random_ray(Random& random, const std::vector<Item>&, const WideTree& tree) {
    const Vec3 size = tree.bounds().size();
    const Vec3 origin = point_in(random, {tree.bounds().low - size, tree.bounds().high + size});
    return {origin, stretched(random, unit(point_in(random, tree.bounds()) - origin))};
}

/// A ray that touches an item as precisely as doubles allow: tangent to a ball, or through a corner
/// or edge of a box.
Ray grazing_ray(Random& random, const std::vector<Item>& items, const WideTree& tree) {
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

/// A ray along an axis, whose other coordinates are those of items or of nodes' boxes, with zeros
/// of both signs.
Ray axis_ray(Random& random, const std::vector<Item>& items, const WideTree& tree) {
    const Item& item = items[random() % items.size()];
    Ray ray{point_in(random, item.box), Vec3(0)};
    for (int axis = 0; axis < 3; ++axis) {
        const TreeNode& node = tree.nodes()[random() % tree.nodes().size()];
        const auto choice = random() % 5;
        if (choice == 0) ray.origin[axis] = item.box.low[axis];
        if (choice == 1) ray.origin[axis] = item.box.high[axis];
        if (choice == 2) ray.origin[axis] = item.centre()[axis];
        if (choice == 3 && node.used(1))
            ray.origin[axis] = node.box(1, tree.frames()[0].origin).low[axis];
        ray.direction[axis] = random() % 2 ? 0.0 : -0.0;
    }
    const auto axis = static_cast<int>(random() % 3);
    const double sign = random() % 2 ? 1 : -1;
    ray.direction[axis] = sign * std::pow(10, uniform(random, -3, 3));
    if (random() % 2)
        ray.origin[axis] -= sign * uniform(random, 0, 2) * max_component(tree.bounds().size());
    return ray;
}

/// A ray that starts in an item's box or on its surface.
Ray inner_ray(Random& random, const std::vector<Item>& items, const WideTree&) {
    const Item& item = items[random() % items.size()];
    const Vec3 on_surface = item.centre() + item.radius * direction(random);
    const Vec3 origin = random() % 2 && item.radius > 0 ? on_surface : point_in(random, item.box);
    return {origin, stretched(random, direction(random))};
}

struct RayKind {
    const char* name;
    Ray (*make)(Random&, const std::vector<Item>&, const WideTree&);
};

constexpr RayKind ray_kinds[] = {{"random", random_ray},
                                 {"grazing", grazing_ray},
                                 {"along an axis", axis_ray},
                                 {"from inside", inner_ray}};

/// Number of rays, out of `count`, for which the two indices disagree on the first or on any hit.
int disagreements(const WideTree& tree, const std::vector<Item>& items, const RayKind& kind,
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

constexpr auto never = [](std::span<const std::uint32_t>, Interval&) { return true; };

}  // namespace

TEST_CASE("both indexes find the hits that brute force finds", "[index]") {
    for (const TreeSettings& settings : both_divisions)
        for (const ItemScene& scene : scenes()) {
            const WideTree tree = tree_of(scene.items, settings);
            for (const RayKind& kind : ray_kinds) {
                CAPTURE(scene.name, kind.name);
                CHECK(disagreements(tree, scene.items, kind, 4000) == 0);
            }
        }
}

TEST_CASE("hits do not depend on the settings of the build", "[index]") {
    const std::vector<Item> items = random_balls(300, 0.02, 0.3, 12);
    const TreeSettings cases[] = {
        {.node_cost = 0}, {.node_cost = 100},       {.group_cost = 0},    {.group = 1},
        {.group = 1000},  {.reference_cost = 1000}, {.reference_cost = 0}};
    for (TreeSettings settings : cases)
        for (const Division by : {Division::boxes, Division::cells}) {
            settings.by = by;
            const WideTree tree = tree_of(items, settings);
            for (const RayKind& kind : ray_kinds) CHECK(disagreements(tree, items, kind, 500) == 0);
        }
}

TEST_CASE("a packed tree finds the same, and gives leaves what was kept for them", "[index]") {
    const std::vector<Item> items = random_balls(3000, 0.005, 0.3, 22);
    WideTree tree = tree_of(items, GENERATE(from_range(both_divisions)));
    std::vector<std::uint32_t> before = items_of(tree);
    REQUIRE(!tree.early_occluders().empty());
    tree.pack({[](std::span<const std::uint32_t> leaf) { return leaf.size(); },
               [](std::span<const std::uint32_t> leaf, const Box&, std::span<std::uint32_t> words) {
                   for (std::size_t i = 0; i < leaf.size(); ++i) words[i] = leaf[i] + 7;
               }});
    CHECK(items_of(tree) == before);
    for (const RayKind& kind : ray_kinds) CHECK(disagreements(tree, items, kind, 500) == 0);
    tree.traverse({Vec3(-3, 0.1, 0.2), Vec3(1, 0, 0)}, {}, [&](const TreeLeaf& leaf, Interval&) {
        for (std::size_t i = 0; i < leaf.items.size(); ++i)
            CHECK(leaf.pack[i] == leaf.items[i] + 7);
        return false;
    });
}

TEST_CASE("an empty hierarchy visits nothing", "[index]") {
    const std::vector<Box> only_empty(3);
    for (const WideTree& tree :
         {WideTree(), build_tree(std::span<const Box>()), build_tree(only_empty)}) {
        CHECK(tree.bounds().empty());
        CHECK_FALSE(tree.traverse({Vec3(0), Vec3(0, 0, 1)}, {}, never));
    }
}

TEST_CASE("rays that cannot meet anything visit nothing", "[index]") {
    const WideTree tree = build_tree(std::vector<Box>{{Vec3(0), Vec3(1)}});
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
    };
    for (const Case& c : cases) CHECK_FALSE(tree.traverse(c.ray, c.range, never));
    // Nothing is known about a ray with a zero direction.
    CHECK(tree.traverse({Vec3(2), Vec3(0)}, {}, never));
}

TEST_CASE("leaves are visited front to back until the hit, or until told to stop", "[index]") {
    std::vector<Item> row;
    for (int i = 0; i < 1000; ++i) row.push_back(ball(Vec3(i, 0, 0), 0.3));
    const WideTree tree = tree_of(row, GENERATE(from_range(both_divisions)));
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

TEST_CASE("items in a row of growing distances stay within the limit of depth", "[index]") {
    std::vector<Item> row;
    for (int i = 0; i < 2000; ++i) {
        const double place = std::pow(1.05, i - 1400);
        row.push_back(ball(Vec3(place, 0, 0), 1e-3 * place));
    }
    const WideTree tree = tree_of(row, GENERATE(from_range(both_divisions)));
    CHECK(items_of(tree).size() == row.size());
    CHECK(statistics(tree).max_depth <= WideTree::depth_limit);
    CHECK(tree.frames().size() > 5);
    for (const RayKind& kind : ray_kinds) CHECK(disagreements(tree, row, kind, 1000) == 0);
}

TEST_CASE("small things far from the middle have frames of their own", "[index]") {
    // Two clouds of tiny balls, each as small as the last digit of the other's coordinates.
    std::vector<Item> items = moved(random_balls(500, 0.01, 0.1, 31), 1e-7, Vec3(1, 2, 3));
    for (const Item& item : moved(random_balls(500, 0.01, 0.1, 32), 1e-7, Vec3(-3, 1, -2)))
        items.push_back(item);
    const WideTree tree = tree_of(items, GENERATE(from_range(both_divisions)));
    CHECK(tree.frames().size() > 2);
    CHECK(tree.frames().size() <= 1 + TreeNode::width);
    for (const RayKind& kind : ray_kinds) CHECK(disagreements(tree, items, kind, 1000) == 0);
    // A ray from one cloud through the other passes near few of its balls.
    Random random(33);
    std::size_t asked = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from = items[500 + random() % 500].centre(), to = items[random() % 500].centre();
        tree.traverse({from, to - from}, {0.5, 2},
                      [&](std::span<const std::uint32_t> leaf, Interval&) {
                          asked += leaf.size();
                          return false;
                      });
    }
    CHECK(asked < 60 * 1000);
}

TEST_CASE("rays that ask for anything in their way pass the same leaves, the likely ones first",
          "[index]") {
    // Tiny balls between the origin and a wall.
    std::vector<Item> items = random_balls(400, 0.001, 0.01, 21);
    items.push_back({{Vec3(2, -1, -1), Vec3(2.1, 1, 1)}});
    const WideTree tree = tree_of(items, GENERATE(from_range(both_divisions)));
    const Ray ray{Vec3(-2, 0.1, 0.2), Vec3(1, 0, 0)};
    std::vector<std::uint32_t> near, likely;
    const auto note = [](std::vector<std::uint32_t>& found) {
        return [&](std::span<const std::uint32_t> leaf, Interval&) {
            found.insert(found.end(), leaf.begin(), leaf.end());
            return false;
        };
    };
    CHECK_FALSE(tree.traverse(ray, {0, 5}, note(near)));
    CHECK_FALSE(tree.traverse_likely(ray, {0, 5}, note(likely)));
    CHECK(near.back() == 400);
    const auto wall = std::ranges::find(likely, 400u);
    CHECK(wall - likely.begin() < 8);
    // Items that were visited early may be visited again in order.
    for (std::vector<std::uint32_t>* found : {&near, &likely}) {
        std::ranges::sort(*found);
        found->erase(std::unique(found->begin(), found->end()), found->end());
    }
    CHECK(near == likely);
}

}  // namespace candelabra
