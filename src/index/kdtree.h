// SPDX-License-Identifier: GPL-3.0-or-later
// A kd-tree over boxes, built with the surface area heuristic: finds the items that a ray may meet,
// nearest cells first. The world builds one over its objects; it knows no shapes, only their boxes
// and a callback that clips them to a cell. Immutable once built, and the same for any number of
// threads. Every item whose clipped box comes near enough to the ray to be hit, rounding errors
// included, is visited; see build_kdtree for what "near enough" promises.
#pragma once

#include "base/box.h"
#include "base/ray.h"

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

/// What steers the build. Costs are relative to each other; the defaults were fitted to measured
/// ray speeds on sphereflakes of 10^4 to 10^6 spheres. Small trees win there, because memory is
/// what rays wait for; a test much slower than a sphere's deserves a higher intersection_cost.
struct KdTreeSettings {
    double traversal_cost = 1;        ///< of going from a cell to its halves
    double intersection_cost = 0.32;  ///< of testing one item
    double empty_bonus = 0.14;        ///< share of the cost forgiven where empty space is cut off
    int max_depth = 0;  ///< 0: 8 + 1.3 log2 of the number of items; never above KdTree::depth_limit
    int leaf_size = 1;  ///< cells with so few items are not divided any more
    /// Cells are not divided further where items have been cut into so many parts on average:
    /// bounds the memory for masses of long thin items.
    double max_duplication = 64;
};

/// Bounds of the part of an item inside a cell; an empty box when the item's surface does not pass
/// through the cell (also when the cell lies wholly inside of it). May be too large, never too
/// small. Called from several threads.
using ClipItem = std::function<Box(std::uint32_t item, const Box& cell)>;

/// Bounds of an item.
using ItemBox = std::function<Box(std::uint32_t item)>;

/// An inner node's plane, or a leaf's range in the array of items. The plane is a double:
/// eight-byte nodes with single precision gained rays a tenth at most among 10^6 spheres, lost them
/// as much among 10^4, and cannot divide small clusters far from the origin.
class KdNode {
public:
    /// Of a cell; where both are as good, rays visit the nearer one first.
    enum class Half : std::uint32_t { neither = 0, above = 1, below = 2 };

    static KdNode inner(int axis, double plane, std::uint32_t first_child) {
        return {plane, first_child, static_cast<std::uint32_t>(axis)};
    }
    static KdNode leaf(std::uint32_t first_item, std::uint32_t count) {
        return {0, first_item, count << 2 | 3};
    }

    bool is_leaf() const { return (kind_ & 3) == 3; }
    std::uint32_t axis() const { return kind_ & 3; }
    double plane() const { return plane_; }
    /// Below the plane; the child above is the next one.
    std::uint32_t first_child() const { return first_; }
    std::uint32_t first_item() const { return first_; }
    std::uint32_t item_count() const { return kind_ >> 2; }
    /// Whether a ray that asks for anything in its way visits the farther child first, of a node
    /// that it passes downwards (backward is 1) or upwards.
    bool starts_far(std::uint32_t backward) const { return (kind_ >> (2 + backward) & 1) != 0; }
    KdNode with_likely(Half half) const {
        return {plane_, first_, axis() | static_cast<std::uint32_t>(half) << 2};
    }
    /// Where a leaf's pack begins in the tree's packs.
    std::uint64_t pack() const { return std::bit_cast<std::uint64_t>(plane_); }
    KdNode with_pack(std::uint64_t first) const {
        return {std::bit_cast<double>(first), first_, kind_};
    }

    /// The same node where its children and items have moved up by so much.
    KdNode moved(std::uint32_t nodes, std::uint32_t items) const {
        return {plane_, first_ + (is_leaf() ? items : nodes), kind_};
    }

    bool operator==(const KdNode&) const = default;

private:
    KdNode(double plane, std::uint32_t first, std::uint32_t kind)
        : plane_(plane), first_(first), kind_(kind) {}

    double plane_;
    std::uint32_t first_;
    /// Low two bits: axis, or 3 for a leaf. Above: a leaf's number of items, or an inner node's
    /// likely half.
    std::uint32_t kind_;
};
static_assert(sizeof(KdNode) == 16);

/// A leaf that a ray passes.
struct KdLeaf {
    std::span<const std::uint32_t> items;
    const float* pack;  ///< what KdTree::pack() was given for them
    double entry;       ///< the ray's parameter where it enters the leaf's cell, or its range
};

/// Appends what is to be kept for a leaf's items; `cell` is the leaf's.
using PackLeaf = std::function<void(std::span<const std::uint32_t> items, const Box& cell,
                                    std::vector<float>& packs)>;

class KdTree {
public:
    static constexpr int depth_limit = 60;

    /// No items: no ray meets anything.
    KdTree() = default;

    /// Calls visit(std::span<const std::uint32_t> items, Interval& range) -> bool for each leaf
    /// with items that the ray passes within the range, front to back; or visit(const KdLeaf&,
    /// Interval& range), of a tree that is packed. visit may lower range.max
    /// when it found a hit; leaves behind it are left out. When visit returns true, traversal stops
    /// and returns true. An item may be visited several times.
    template <class Visit>
    bool traverse(const Ray& ray, Interval range, Visit&& visit) const {
        return walk<false>(ray, range, visit);
    }

    /// The same for who only wants to know whether anything is met: first where the ray, for its
    /// steps, is likeliest to be stopped. visit leaves range as it is.
    template <class Visit>
    bool traverse_likely(const Ray& ray, Interval range, Visit&& visit) const {
        return walk<true>(ray, range, visit);
    }

    /// Holds all items, and is a little larger than their boxes together.
    const Box& bounds() const { return bounds_; }
    std::span<const KdNode> nodes() const { return nodes_; }
    /// Items in the order of the leaves: for callers that keep copies of them in this order. The
    /// span given to visit is a part of this one.
    std::span<const std::uint32_t> items() const { return items_; }
    const KdTreeSettings& settings() const { return settings_; }
    std::size_t memory_bytes() const;

    /// Has each leaf with items keep what the function appends for it, beside their numbers.
    void pack(const PackLeaf&);

private:
    friend KdTree build_kdtree(std::uint32_t, const ItemBox&, const ClipItem&,
                               const KdTreeSettings&, int);
    KdTree(const Box& bounds, std::vector<KdNode> nodes, std::vector<std::uint32_t> items,
           const KdTreeSettings&);

    struct Pending {
        std::uint32_t node;
        double min, max;
    };

    template <bool likely_first, class Visit>
    bool walk(const Ray& ray, Interval range, Visit& visit) const;

    Box bounds_;
    std::vector<KdNode> nodes_;
    std::vector<std::uint32_t> items_;
    std::vector<float> packs_;
    KdTreeSettings settings_;
};

/// Items with an empty box are left out; boxes must be finite, and fewer than 2^30. Without a clip
/// function, boxes are clipped. threads = 0 means one per core.
///
/// Cells and boxes are held against each other with a slack of 2^-46 of the largest coordinate: an
/// item lies on both sides of a plane that it nearly touches. This is some thirty times the
/// rounding error of a plane's ray parameter, so a hit within that distance of its item is found
/// for all origins up to thirty times as far away as the items.
KdTree build_kdtree(std::uint32_t items, const ItemBox&, const ClipItem&,
                    const KdTreeSettings& = {}, int threads = 0);
inline KdTree build_kdtree(std::span<const Box> boxes, const ClipItem& clip_item,
                           const KdTreeSettings& settings = {}, int threads = 0) {
    return build_kdtree(
        static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t item) { return boxes[item]; },
        clip_item, settings, threads);
}

template <bool likely_first, class Visit>
bool KdTree::walk(const Ray& ray, Interval range, Visit& visit) const {
    if (nodes_.empty()) return false;
    // For a zero component of the direction, planes lie at plus or minus infinity, or at NaN for an
    // origin on the plane: the comparisons with bounds are written so that NaN cuts off nothing,
    // those with planes so that one side is passed. What the ray meets lies on both sides there,
    // thanks to the slack, as it does where a range ends on a plane.
    std::array<double, 3> inverse;
    std::array<std::uint32_t, 3> backward;
    const std::array<const Vec3*, 2> corners = {&bounds_.low, &bounds_.high};
    double min = range.min;
    double max = range.max;
    for (int axis = 0; axis < 3; ++axis) {
        inverse[axis] = 1 / ray.direction[axis];
        backward[axis] = std::signbit(ray.direction[axis]);
        const Vec3 &first = *corners[backward[axis]], &last = *corners[backward[axis] ^ 1];
        const double near = (first[axis] - ray.origin[axis]) * inverse[axis];
        const double far = (last[axis] - ray.origin[axis]) * inverse[axis];
        min = near > min ? near : min;
        max = far < max ? far : max;
    }
    if (!(min <= max)) return false;
    const std::array<double, 3> origin = {ray.origin.x, ray.origin.y, ray.origin.z};

    std::array<Pending, depth_limit> pending;
    Pending* pending_end = pending.data();
    const KdNode* const nodes = nodes_.data();
    const KdNode* node = nodes;
    for (;;) {
        while (!node->is_leaf()) {
            const std::uint32_t axis = node->axis();
            const double t = (node->plane() - origin[axis]) * inverse[axis];
            const std::uint32_t near = node->first_child() + backward[axis];
            const std::uint32_t far = node->first_child() + (backward[axis] ^ 1);
            if (!(t < max)) {
                node = nodes + near;
            } else if (!(t > min)) {
                node = nodes + far;
            } else if (likely_first && node->starts_far(backward[axis])) {
                *pending_end++ = {near, min, t};
                min = t;
                node = nodes + far;
            } else {
                *pending_end++ = {far, t, max};
                max = t;
                node = nodes + near;
            }
        }
        if (const std::uint32_t count = node->item_count(); count > 0) {
            const auto items = std::span(items_).subspan(node->first_item(), count);
            if constexpr (std::invocable<Visit, const KdLeaf&, Interval&>) {
                if (visit(KdLeaf{items, packs_.data() + node->pack(), min}, range)) return true;
            } else {
                if (visit(items, range)) return true;
            }
        }
        if (pending_end == pending.data()) return false;
        const Pending& next = *--pending_end;
        if (next.min > range.max) return false;
        node = nodes + next.node;
        min = next.min;
        max = next.max < range.max ? next.max : range.max;
    }
}
