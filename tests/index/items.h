// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres and boxes as items of an index, and the scenes made of them that the index tests share.
#pragma once

#include "base/ray.h"
#include "index/settings.h"
#include "index/tree_builder.h"
#include "shape/sphere.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace candelabra {

constexpr double no_hit = std::numeric_limits<double>::infinity();

/// A sphere if the radius is positive, else the box.
struct Item {
    Box box;
    double radius = 0;

    Vec3 centre() const { return box.centre(); }
};

inline Item ball(const Vec3& centre, double radius) {
    return {{centre - Vec3(radius), centre + Vec3(radius)}, radius};
}

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}
inline Vec3 point_in(Random& random, const Box& box) {
    const double x = uniform(random, box.low.x, box.high.x);
    const double y = uniform(random, box.low.y, box.high.y);
    return {x, y, uniform(random, box.low.z, box.high.z)};
}
inline Vec3 direction(Random& random) {
    for (;;) {
        const Vec3 v = point_in(random, {Vec3(-1), Vec3(1)});
        if (dot(v, v) <= 1 && dot(v, v) > 0.01) return unit(v);
    }
}

/// The nearest crossing of the item's surface in the range, or no_hit.
inline double meet(const Item& item, const Ray& ray, const Interval& range) {
    Interval crossed;
    if (item.radius > 0) {
        const Vec3 to = item.centre() - ray.origin;
        const double length2 = dot(ray.direction, ray.direction);
        const double along = dot(to, ray.direction) / length2;
        const Vec3 off = to - along * ray.direction;
        const double spare = item.radius * item.radius - dot(off, off);
        if (spare < 0) return no_hit;
        const double half = std::sqrt(spare / length2);
        crossed = {along - half, along + half};
    } else {
        crossed = clip(ray, item.box, {-no_hit, no_hit});
        if (!(crossed.min <= crossed.max)) return no_hit;
    }
    if (range.contains(crossed.min)) return crossed.min;
    return range.contains(crossed.max) ? crossed.max : no_hit;
}

struct ItemHit {
    double t = no_hit;
    std::uint32_t item = ~0u;

    bool operator==(const ItemHit&) const = default;
};

/// Among hits at the same place the lowest item counts, so that the order of visits does not
/// matter.
template <class Index>
ItemHit first_hit(const Index& index, const std::vector<Item>& items, const Ray& ray,
                  Interval whole = {}) {
    ItemHit hit;
    index.traverse(ray, whole, [&](std::span<const std::uint32_t> leaf, Interval& range) {
        for (const std::uint32_t i : leaf) {
            const double t = meet(items[i], ray, whole);
            if (t < no_hit && (t < hit.t || (t == hit.t && i < hit.item))) hit = {t, i};
        }
        range.max = std::min(range.max, hit.t);
        return false;
    });
    return hit;
}

template <class Index>
bool any_hit(const Index& index, const std::vector<Item>& items, const Ray& ray,
             const Interval& whole) {
    const auto visit = [&](std::span<const std::uint32_t> leaf, Interval&) {
        for (const std::uint32_t i : leaf) {
            if (meet(items[i], ray, whole) < no_hit) return true;
        }
        return false;
    };
    if constexpr (std::is_same_v<Index, WideTree>)
        return index.traverse_likely(ray, whole, visit);
    else
        return index.traverse(ray, whole, visit);
}

inline std::vector<Box> boxes_of(const std::vector<Item>& items) {
    std::vector<Box> boxes;
    for (const Item& item : items) boxes.push_back(item.box);
    return boxes;
}

/// Bounds of the part of the item in a cell: of a ball's surface, or of the whole box.
inline Box part_of(const Item& item, const Box& cell) {
    return item.radius > 0 ? clipped_bounds(Sphere{item.centre(), item.radius}, cell)
                           : clip(item.box, cell);
}

/// Balls are cut in trees with cells; hierarchies of boxes keep them whole.
inline WideTree tree_of(const std::vector<Item>& items, const TreeSettings& settings = {},
                        int threads = 1) {
    const auto part = [&](std::uint32_t item, const Box& cell) {
        return part_of(items[item], cell);
    };
    return build_tree(
        static_cast<std::uint32_t>(items.size()),
        [&](std::uint32_t item) { return items[item].box; },
        settings.by == Division::cells ? ItemPart(part) : ItemPart(), settings, threads);
}

/// Both ways to divide items, with the usual costs.
inline const std::array both_divisions = {tree_settings(KdTree()), tree_settings(BoundingBoxes())};

/// Items in the order of the leaves, including duplicates; without the early occluders.
inline std::vector<std::uint32_t> items_of(const WideTree& tree) {
    std::vector<std::uint32_t> items;
    for (const TreeNode& node : tree.nodes())
        for (std::size_t slot = 0; slot < TreeNode::width; ++slot) {
            if (!node.used(slot) || !node.children[slot].is_leaf()) continue;
            const auto leaf = tree.items(node.children[slot]);
            items.insert(items.end(), leaf.begin(), leaf.end());
        }
    return items;
}

/// The same without duplicates, in ascending order.
inline std::vector<std::uint32_t> different_items_of(const WideTree& tree) {
    std::vector<std::uint32_t> items = items_of(tree);
    std::ranges::sort(items);
    items.erase(std::unique(items.begin(), items.end()), items.end());
    return items;
}

inline std::vector<Item> random_balls(std::size_t count, double low_radius, double high_radius,
                                      std::uint64_t seed) {
    Random random(seed);
    std::vector<Item> items;
    while (items.size() < count) {
        const double radius =
            low_radius * std::pow(high_radius / low_radius, uniform(random, 0, 1));
        items.push_back(ball(point_in(random, {Vec3(-1), Vec3(1)}), radius));
    }
    return items;
}

/// Boxes that are flat along one to three axes, with coordinates on a coarse grid so that many
/// coincide.
inline std::vector<Item> flat_boxes(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    const auto grid = [&] { return std::round(uniform(random, -8, 8)) / 8; };
    std::vector<Item> items;
    while (items.size() < count) {
        const Vec3 a(grid(), grid(), grid());
        const Vec3 b(grid(), grid(), grid());
        Box box{glm::min(a, b), glm::max(a, b)};
        const auto flat = static_cast<int>(random() % 3);
        box.high[flat] = box.low[flat];
        items.push_back({box});
    }
    return items;
}

inline std::vector<Item> touching_boxes(int side) {
    std::vector<Item> items;
    for (int i = 0; i < side * side * side; ++i) {
        const Vec3 low(i % side, i / side % side, i / (side * side));
        items.push_back({{low, low + Vec3(1)}});
    }
    return items;
}

inline std::vector<Item> touching_balls(int side) {
    std::vector<Item> items;
    for (const Item& box : touching_boxes(side)) items.push_back(ball(box.centre(), 0.5));
    return items;
}

/// Radii from 1e-6 to 1e6; the distance of each ball is of the order of its radius.
inline std::vector<Item> all_scales(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Item> items;
    while (items.size() < count) {
        const double radius = std::pow(10, uniform(random, -6, 6));
        items.push_back(ball(direction(random) * radius * uniform(random, 1.1, 8), radius));
    }
    return items;
}

inline std::vector<Item> moved(std::vector<Item> items, double scale, const Vec3& by) {
    for (Item& item : items) {
        item = item.radius > 0 ? ball(item.centre() * scale + by, item.radius * scale)
                               : Item{{item.box.low * scale + by, item.box.high * scale + by}};
    }
    return items;
}

struct ItemScene {
    std::string name;
    std::vector<Item> items;
};

inline std::vector<ItemScene> scenes() {
    std::vector<ItemScene> all = {
        {"one ball", random_balls(1, 0.5, 0.5, 1)},
        {"small balls", random_balls(500, 0.01, 0.1, 2)},
        {"overlapping balls", random_balls(200, 0.2, 1, 3)},
        {"coincident balls", std::vector<Item>(100, ball(Vec3(0.25, 0.5, 1), 1))},
        {"concentric balls", {}},
        {"touching balls", touching_balls(7)},
        {"touching boxes", touching_boxes(6)},
        {"flat boxes", flat_boxes(300, 4)},
        {"all scales", all_scales(400, 5)},
        {"balls far away", moved(random_balls(400, 0.01, 0.2, 6), 1, Vec3(1e6, -1e6, 1e6))},
        {"flat boxes far away", moved(flat_boxes(300, 7), 1, Vec3(-1e6, 1e6, 0))},
        {"tiny balls", moved(random_balls(400, 0.01, 0.2, 8), 1e-9, Vec3(0))},
        {"huge balls", moved(random_balls(400, 0.01, 0.2, 9), 1e9, Vec3(0))},
        {"balls near the least numbers", moved(random_balls(400, 0.01, 0.2, 23), 1e-40, Vec3(0))},
        {"points", random_balls(300, 1e-300, 1e-300, 10)},
    };
    for (int i = 1; i <= 200; ++i) all[4].items.push_back(ball(Vec3(0), i * 0.01));
    for (Item& item : all.back().items) item = {{item.centre(), item.centre()}};
    return all;
}

}  // namespace candelabra
