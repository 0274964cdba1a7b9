// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres, triangles, and bounding boxes of other items of an index leaf in single precision,
// tested eight at a time. The test rules out items that a ray surely misses, so that few are left
// for the exact tests. Coordinates are relative to the centre of the leaf's box. Each radius, edge
// and box is enlarged by the possible rounding error, so no item that the exact tests hit is ever
// ruled out. Called by the world, whose results do not depend on it.
#pragma once

#include "base/lanes.h"
#include "index/wide_tree.h"

#include <algorithm>
#include <bit>

namespace candelabra {

/// Kinds of the items: spheres below `triangles_begin`, triangles below `others_begin`.
struct PackedKinds {
    struct Ball {
        Vec3 centre;
        double radius;
    };
    std::uint32_t triangles_begin, others_begin;
    std::function<Ball(std::uint32_t item)> sphere;
    std::function<std::array<Vec3, 3>(std::uint32_t item)> corners;
    std::function<Box(std::uint32_t item)> box;  ///< bounds of any other item
};

/// Packs leaves whose items are in ascending order; see WideTree::pack.
LeafPacks leaf_packs(PackedKinds);

/// Number of words at the beginning of a pack: the origin of its coordinates and the largest
/// coordinate, all in single precision, then the numbers of spheres and of triangles. Rows with one
/// coordinate each follow: the spheres' centres and radii, the triangles' corners, the lowest and
/// highest corners of boxes.
inline constexpr std::size_t pack_head = 6;

/// A ray that is tested against many leaves.
class PackRay {
public:
    /// Keeps a reference to the ray: a copy would have to be written to memory before it is read.
    explicit PackRay(const Ray& ray) : ray_(ray) {}
    explicit PackRay(Ray&&) = delete;

    /// Calls ask(item) -> bool for each item of the leaf that the ray may hit in the range, and for
    /// all items of a tree without packs. Stops and returns true when ask does.
    template <class Ask>
    bool candidates(const TreeLeaf& leaf, const Interval& range, Ask ask) {
        if (asks_all(leaf)) return std::ranges::any_of(leaf.items, ask);
        return any(near(leaf, range), leaf, ask);
    }

    /// Variant for occlusion tests in which every sphere and every triangle counts. Returns true
    /// without asking when an item is hit beyond doubt. Few hits are in doubt, so this spares most
    /// rays the access to the items themselves.
    template <class Ask>
    bool blocked(const TreeLeaf& leaf, const Interval& range, Ask ask) {
        if (asks_all(leaf)) return std::ranges::any_of(leaf.items, ask);
        const Answer answer = near_or_sure(leaf, range);
        return answer.sure != 0 || any(answer.near, leaf, ask);
    }

private:
    /// A bit mask of the items of a leaf.
    struct Answer {
        std::uint32_t near;  ///< items that the ray may hit
        std::uint32_t sure;  ///< items that the ray hits beyond doubt
    };
    struct Here;

    /// Up to this number of boxes, the exact tests are faster than the packed one.
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
    // Set at the first leaf; in many scenes most rays reach none.
    double length_ = 0;           ///< of the direction
    double origin_size_;          ///< sum of the absolute coordinates of the origin
    std::array<float, 3> along_;  ///< unit direction
    // Set at the first triangle.
    bool sheared_ = false;
    std::array<float, 2> shear_;  ///< of the axes x_ and y_ along the dominant axis z_
    std::size_t x_, y_, z_;
};

}  // namespace candelabra
