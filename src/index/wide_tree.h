// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of boxes: finds the items that a ray may meet. Its boxes are those of a kd-tree's cells,
// or those of a hierarchy of bounding boxes: the builders differ, rays walk both by the same steps.
// The world builds one over its objects; it knows no shapes, only their boxes.
// A node has up to eight children, whose boxes a ray is held against at once, in single precision.
// Where boxes become so small that this does not tell them apart any more, a new frame begins,
// whose coordinates are counted from its own origin. Immutable once built, and the same for any
// number of threads. Every item whose box the ray meets is visited, rounding errors included; see
// build_tree for what that promises. Items without end are visited by every ray.
#pragma once

#include "base/box.h"
#include "base/function_ref.h"
#include "base/ray.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace candelabra {

/// How items are divided.
enum class Division : std::uint8_t {
    boxes,  ///< each into one group, whose boxes may overlap: a hierarchy of bounding boxes
    cells,  ///< by planes: an item stands in each cell that it passes through, as in a kd-tree
};

/// What steers the build. Costs are relative to each other.
struct TreeSettings {
    Division by = Division::boxes;
    double node_cost = 1;       ///< of holding a ray against the boxes of a node
    double group_cost = 1;      ///< of testing a group of items
    double reference_cost = 0;  ///< of an item that comes to be in one cell more
    int group = 8;              ///< so many items of a leaf are tested at once
};

/// What a slot of a node refers to. Rays wait for where the next node is, so a child that is a node
/// has its place in eights of bytes, and nothing else in it.
class TreeChild {
public:
    static constexpr std::uint32_t node_size = 7 * 32;

    static TreeChild node(std::uint32_t number) { return TreeChild(number * (node_size / 8)); }
    static TreeChild frame(std::uint32_t number) { return TreeChild(number << 2 | frame_kind); }
    /// Where the number of the leaf's items stands, which these follow: counted in words, and in
    /// fours of them in a tree that is packed.
    static TreeChild leaf(std::size_t place) {
        return TreeChild(static_cast<std::uint32_t>(place) << 1 | leaf_kind);
    }

    TreeChild() = default;

    bool is_leaf() const { return (bits_ & leaf_kind) != 0; }
    bool is_frame() const { return (bits_ & (leaf_kind | frame_kind)) == frame_kind; }
    bool is_node() const { return (bits_ & (leaf_kind | frame_kind)) == 0; }
    std::uint32_t node() const { return bits_ / (node_size / 8); }
    /// In bytes.
    std::size_t node_place() const { return std::size_t{bits_} * 8; }
    std::uint32_t frame() const { return bits_ >> 2; }
    std::size_t leaf() const { return bits_ >> 1; }

    bool operator==(const TreeChild&) const = default;

private:
    static constexpr std::uint32_t leaf_kind = 1, frame_kind = 2;
    explicit TreeChild(std::uint32_t bits) : bits_(bits) {}

    std::uint32_t bits_;  // not initialised: stacks of them are long
};

/// Eight boxes, counted from the frame's origin, and what is in them. Of slots that are not in use,
/// the lower ends are infinite.
struct alignas(32) TreeNode {
    static constexpr std::size_t width = 8;
    using Row = std::array<float, width>;

    // The children are between the ends of the boxes, and so in a line of the cache that is asked
    // for before it is known which of them are wanted.
    std::array<Row, 3> low;  ///< of each axis
    std::array<TreeChild, width> children;
    std::array<Row, 3> high;

    TreeNode() { children.fill(TreeChild::leaf(0)); }

    bool used(std::size_t slot) const { return low[0][slot] <= high[0][slot]; }
    Box box(std::size_t slot, const Vec3& origin) const {
        return {origin + Vec3(low[0][slot], low[1][slot], low[2][slot]),
                origin + Vec3(high[0][slot], high[1][slot], high[2][slot])};
    }

    bool operator==(const TreeNode&) const = default;
};
static_assert(sizeof(TreeNode) == TreeChild::node_size);

/// A part of the tree whose coordinates are counted from a point of its own.
struct TreeFrame {
    Vec3 origin;         ///< in the middle
    double reach;        ///< largest distance from there on an axis
    std::uint32_t root;  ///< the node with the first boxes

    bool operator==(const TreeFrame&) const = default;
};

/// A leaf whose box a ray meets.
struct TreeLeaf {
    std::span<const std::uint32_t> items;  ///< at most 8, in ascending order
    /// What WideTree::pack() was given for them; null in a tree that is not packed.
    const std::uint32_t* pack;
    double entry;  ///< the ray's parameter somewhere near: where it enters the leaf's box, or its
                   ///< range
};

/// What is to be kept for the items of leaves. Called from several threads.
struct LeafPacks {
    /// In so many words.
    std::function<std::size_t(std::span<const std::uint32_t> items)> size;
    /// Fills these in; `box` is around the items.
    std::function<void(std::span<const std::uint32_t> items, const Box& box,
                       std::span<std::uint32_t> words)>
        fill;
};

class WideTree {
public:
    /// More levels of nodes there never are.
    static constexpr int depth_limit = 32;
    /// As many items there may be, and one less: what their leaves and nodes can count.
    static constexpr std::uint32_t item_limit = 1u << 28;

    /// No items: no ray meets anything.
    WideTree() = default;

    /// Calls visit(const TreeLeaf&, Interval& range) -> bool, or visit(std::span<const
    /// std::uint32_t> items, Interval& range), for each leaf whose box the ray meets within the
    /// range, nearer ones first where boxes do not overlap. visit may lower range.max when it found
    /// a hit; leaves behind it are left out. When visit returns true, traversal stops and returns
    /// true. An item of several leaves may be visited several times.
    template <class Visit>
    bool traverse(const Ray& ray, Interval range, Visit&& visit) const {
        const auto own = as_leaf_visit(visit);
        return (!endless_.empty() && visit_endless(range, own)) ||
               (!frames_.empty() && walk(frames_[0], ray, range, own));
    }

    /// The same to find only whether anything is met: first where the ray, for its
    /// steps, is likeliest to be stopped. visit leaves range as it is. Any item may be visited
    /// several times.
    template <class Visit>
    bool traverse_likely(const Ray& ray, Interval range, Visit&& visit) const {
        const auto own = as_leaf_visit(visit);
        return (!endless_.empty() && visit_endless(range, own)) ||
               (!frames_.empty() &&
                (visit_foremost(ray, range, own) || walk_likely(frames_[0], ray, range, own)));
    }

    /// Around all items but those without end.
    const Box& bounds() const { return bounds_; }
    std::span<const TreeNode> nodes() const { return nodes_; }
    std::span<const TreeFrame> frames() const { return frames_; }
    /// Calls use(number, frame, level) for each node, those above others first; the root's level is
    /// 1.
    void for_each_node(
        FunctionRef<void(std::uint32_t number, const TreeFrame&, int level)> use) const;
    /// The items of a child that is a leaf.
    std::span<const std::uint32_t> items(TreeChild leaf) const;
    /// Leaves that are visited before all others when anything will do: large things, which stop
    /// many rays. Their items are in the tree as well.
    std::span<const TreeChild> early_occluders() const { return foremost_; }
    /// Items whose boxes are not finite: in no leaf, and visited by every ray.
    std::span<const std::uint32_t> endless() const { return endless_; }
    const TreeSettings& settings() const { return settings_; }
    std::size_t memory_bytes() const;

    /// Has each leaf keep something beside its items. Once. threads = 0 means one per core.
    void pack(const LeafPacks&, int threads = 0);

private:
    using Visit = FunctionRef<bool(const TreeLeaf&, Interval&)>;
    friend class TreeBuilder;

    bool walk(const TreeFrame&, const Ray&, Interval& range, Visit) const;
    bool walk_likely(const TreeFrame&, const Ray&, Interval& range, Visit) const;
    template <bool likely_first>
    bool walk_any(const TreeFrame&, const Ray&, Interval& range, Visit) const;
    bool visit_foremost(const Ray&, Interval& range, Visit) const;
    bool visit_endless(Interval& range, Visit) const;
    TreeLeaf leaf(TreeChild child, double entry) const {
        const bool packed = !packs_.empty();
        const std::uint32_t* const items =
            (packed ? packs_.data() + 4 * child.leaf() : leaves_.data() + child.leaf()) + 1;
        return {{items, items[-1]}, packed ? items + items[-1] : nullptr, entry};
    }

    template <class OwnVisit>
    static auto as_leaf_visit(OwnVisit& visit) {
        if constexpr (std::invocable<OwnVisit, const TreeLeaf&, Interval&>)
            return std::ref(visit);
        else
            return [&visit](const TreeLeaf& leaf, Interval& range) {
                return visit(leaf.items, range);
            };
    }

    Box bounds_;
    std::vector<TreeFrame> frames_;  ///< the first is the whole
    std::vector<TreeNode> nodes_;
    /// For each leaf the number of its items, and the items; nothing once packed. The first one has
    /// none.
    std::vector<std::uint32_t> leaves_;
    /// The same, and what is kept for them.
    std::vector<std::uint32_t> packs_;
    std::vector<TreeChild> foremost_;
    std::vector<std::uint32_t> endless_;
    TreeSettings settings_;
};

}  // namespace candelabra
