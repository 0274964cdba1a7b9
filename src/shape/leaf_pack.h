// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres, triangles and boxes around other things of a kd-tree's leaf in single precision, eight
// at a time: rules out those that a ray surely misses, so that few are left for the exact tests.
// Coordinates are measured from the middle of the leaf's cell, and what rounding may cost is added
// to each radius, edge and box, so nothing that the exact tests meet is ever ruled out. Called by
// the world, whose answers do not depend on it.
#pragma once

#include "index/kdtree.h"

#include <algorithm>
#include <bit>

/// What items are: spheres below `triangles_begin`, triangles below `others_begin`.
struct PackedKinds {
    struct Ball {
        Vec3 centre;
        double radius;
    };
    std::uint32_t triangles_begin, others_begin;
    std::function<Ball(std::uint32_t item)> sphere;
    std::function<std::array<Vec3, 3>(std::uint32_t item)> corners;
    std::function<Box(std::uint32_t item)> box;  ///< around any other item
};

/// Appends the pack of a leaf, whose items are in ascending order; see KdTree::pack.
void pack_leaf(const PackedKinds&, std::span<const std::uint32_t> items, const Box& cell,
               std::vector<float>& packs);

/// Numbers of floats at the beginning of a pack: the point that the others are measured from, the
/// largest coordinate, the numbers of spheres and of triangles as bits. Rows of a coordinate each
/// follow: the spheres' centres and radii, the triangles' corners, the lowest and highest corners
/// of boxes.
inline constexpr std::size_t pack_head = 6;
inline constexpr std::size_t pack_lanes = 8;

/// A ray that asks many leaves.
class PackRay {
public:
    explicit PackRay(const Ray& ray) : origin_(ray.origin), direction_(ray.direction) {}

    /// Calls ask(item) -> bool for each item of the leaf that the ray may meet in the range, and
    /// for all of a tree without packs; stops and returns true when ask does.
    template <class Ask>
    bool candidates(const KdLeaf& leaf, const Interval& range, Ask ask) {
        return candidates<false>(leaf, range, ask);
    }

    /// The same for who only wants to know whether anything is met, where every sphere and every
    /// triangle counts: true without asking for items that are met beyond doubt. Where a ray ends
    /// is seldom in doubt, so this spares most rays a look at the items themselves.
    template <class Ask>
    bool blocked(const KdLeaf& leaf, const Interval& range, Ask ask) {
        return candidates<true>(leaf, range, ask);
    }

private:
    /// A bit for each of the first lanes of the rows.
    struct Lanes {
        std::uint32_t near;  ///< those that the ray may meet
        std::uint32_t sure;  ///< those that it meets beyond doubt, where that was asked
    };

    template <bool any_will_do, class Ask>
    bool candidates(const KdLeaf& leaf, const Interval& range, Ask& ask) {
        if (!leaf.pack) return std::ranges::any_of(leaf.items, ask);
        const auto spheres = std::bit_cast<std::uint32_t>(leaf.pack[4]),
                   triangles = std::bit_cast<std::uint32_t>(leaf.pack[5]);
        const auto others = static_cast<std::uint32_t>(leaf.items.size()) - spheres - triangles;
        const bool few = others <= few_boxes;  // to look at them takes longer than to ask
        if (spheres + triangles > 0 || !few) start(leaf, range);
        const float* rows = leaf.pack + pack_head;
        const std::uint32_t* items = leaf.items.data();
        const auto found = [&](Lanes lanes, std::uint32_t left, const std::uint32_t* here) {
            const std::uint32_t there = first_lanes(left);
            return (any_will_do && (lanes.sure & there) != 0) || any(lanes.near & there, here, ask);
        };
        for (std::uint32_t i = 0; i < spheres; i += pack_lanes)
            if (found(
                    any_will_do ? sure_spheres(rows + i, spheres) : near_spheres(rows + i, spheres),
                    spheres - i, items + i))
                return true;
        rows += 4 * std::size_t{spheres};
        items += spheres;
        for (std::uint32_t i = 0; i < triangles; i += pack_lanes)
            if (found(near_triangles(rows + i, triangles), triangles - i, items + i)) return true;
        items += triangles;
        if (few) return std::any_of(items, items + others, ask);
        rows += 9 * std::size_t{triangles};
        for (std::uint32_t i = 0; i < others; i += pack_lanes)
            if (any(near_boxes(rows + i, others) & first_lanes(others - i), items + i, ask))
                return true;
        return false;
    }
    static constexpr std::uint32_t few_boxes = 2;
    static std::uint32_t first_lanes(std::uint32_t count) {
        return count < pack_lanes ? (1u << count) - 1 : (1u << pack_lanes) - 1;
    }
    template <class Ask>
    static bool any(std::uint32_t lanes, const std::uint32_t* items, Ask& ask) {
        for (; lanes != 0; lanes &= lanes - 1)
            if (ask(items[std::countr_zero(lanes)])) return true;
        return false;
    }

    void prepare();
    void start(const KdLeaf&, const Interval&);
    /// The rows are `stride` apart.
    Lanes near_spheres(const float* rows, std::size_t stride) const;
    Lanes sure_spheres(const float* rows, std::size_t stride) const;
    Lanes near_triangles(const float* rows, std::size_t stride) const;
    std::uint32_t near_boxes(const float* rows, std::size_t stride) const;
    template <bool sure>
    Lanes ask_spheres(const float* rows, std::size_t stride) const;

    Vec3 origin_, direction_;
    // Known when the first leaf is met; most rays of many scenes meet none.
    double length_ = 0;           ///< of the direction
    std::array<float, 3> along_;  ///< unit direction
    std::array<float, 3> steps_;  ///< its inverse
    std::array<float, 2> shear_;  ///< of the axes x_ and y_ along the longest one, z_
    int x_, y_, z_;
    // For the leaf in hand, in units of length.
    std::array<float, 3> point_;  ///< the ray's point at the leaf's entry
    float least_, most_;          ///< the range, from that point on
    float slack_;                 ///< of points along the ray, by the rounding of doubles
    float reach_;                 ///< largest coordinate in the leaf
    float margin_;                ///< of edges, by all rounding
};
