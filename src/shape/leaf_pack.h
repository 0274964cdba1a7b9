// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres, triangles and boxes around other things of a leaf of the index in single precision,
// eight at a time: rules out those that a ray surely misses, so that few are left for the exact
// tests. Coordinates are measured from the middle of the leaf's box, and what rounding may cost is
// added to each radius, edge and box, so nothing that the exact tests meet is ever ruled out.
// Called by the world, whose answers do not depend on it.
#pragma once

#include "base/lanes.h"
#include "index/wide_tree.h"

#include <algorithm>
#include <bit>

namespace candelabra {

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

/// Packs of leaves, whose items are in ascending order; see WideTree::pack.
LeafPacks leaf_packs(PackedKinds);

/// Numbers of words at the beginning of a pack: the point that coordinates are measured from and
/// the largest of these, all in single precision, the numbers of spheres and of triangles. Rows of
/// a coordinate each follow: the spheres' centres and radii, the triangles' corners, the lowest and
/// highest corners of boxes.
inline constexpr std::size_t pack_head = 6;

/// A ray that asks many leaves.
class PackRay {
public:
    /// The ray is looked at where it is: a copy would have to be written before it can be read.
    explicit PackRay(const Ray& ray) : ray_(ray) {}
    explicit PackRay(Ray&&) = delete;

    /// Calls ask(item) -> bool for each item of the leaf that the ray may meet in the range, and
    /// for all of a tree without packs; stops and returns true when ask does.
    template <class Ask>
    bool candidates(const TreeLeaf& leaf, const Interval& range, Ask ask) {
        if (asks_all(leaf)) return std::ranges::any_of(leaf.items, ask);
        return any(near(leaf, range), leaf, ask);
    }

    /// The same to find only whether anything is met, where every sphere and every
    /// triangle counts: true without asking for items that are met beyond doubt. Where a ray ends
    /// is seldom in doubt, so this spares most rays a look at the items themselves.
    template <class Ask>
    bool blocked(const TreeLeaf& leaf, const Interval& range, Ask ask) {
        if (asks_all(leaf)) return std::ranges::any_of(leaf.items, ask);
        const Answer answer = near_or_sure(leaf, range);
        return answer.sure != 0 || any(answer.near, leaf, ask);
    }

private:
    /// A bit for each item of a leaf.
    struct Answer {
        std::uint32_t near;  ///< those that the ray may meet
        std::uint32_t sure;  ///< those that it meets beyond doubt
    };
    struct Here;

    /// To look at few boxes takes longer than to ask.
    static constexpr std::size_t few_boxes = 2;
    bool asks_all(const TreeLeaf& leaf) {
        if (!leaf.pack || (leaf.items.size() <= few_boxes && leaf.pack[4] + leaf.pack[5] == 0))
            return true;
        if (length_ == 0) prepare();
        if (!sheared_ && leaf.pack[5] > 0) prepare_for_triangles();
        return false;
    }
    template <class Ask>
    static bool any(std::uint32_t lanes, const TreeLeaf& leaf, Ask& ask) {
        for (; lanes != 0; lanes &= lanes - 1)
            if (ask(leaf.items[static_cast<std::size_t>(std::countr_zero(lanes))])) return true;
        return false;
    }

    void prepare();
    void prepare_for_triangles();
    std::uint32_t near(const TreeLeaf&, const Interval&) const;
    Answer near_or_sure(const TreeLeaf&, const Interval&) const;
    template <bool sure>
    Answer look_at(const TreeLeaf&, const Interval&) const;
    template <bool sure>
    Answer look_at_spheres(const Here&, const std::uint32_t* rows, std::uint32_t count) const;
    Answer look_at_triangles(const Here&, const std::uint32_t* rows, std::uint32_t count) const;
    std::uint32_t look_at_boxes(const Here&, const std::uint32_t* rows, std::uint32_t count) const;

    const Ray& ray_;
    // Known when the first leaf is met; most rays of many scenes meet none.
    double length_ = 0;           ///< of the direction
    double origin_size_;          ///< sum of the origin's coordinates
    std::array<float, 3> along_;  ///< unit direction
    // Known when the first triangle is met.
    bool sheared_ = false;
    std::array<float, 2> shear_;  ///< of the axes x_ and y_ along the longest one, z_
    std::size_t x_, y_, z_;
};

}  // namespace candelabra
