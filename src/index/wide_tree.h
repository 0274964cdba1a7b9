// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of boxes that finds the items a ray may meet. The boxes are the cells of a kd-tree, or a
// hierarchy of bounding boxes: the builders differ, traversal is the same. The world builds one
// over its objects. The tree knows only boxes, no shapes.
// A node has up to eight children, whose boxes are tested at once, in single precision. Where boxes
// become too small for that precision, a new frame begins, with coordinates relative to its own
// origin. The tree is immutable once built, and the same for any number of threads. Every item
// whose box the ray meets is visited in spite of rounding errors, within the limits that build_tree
// gives. Items without finite bounds are visited by every ray.
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
    boxes,  ///< each is in one group, and boxes may overlap: a bounding volume hierarchy
    cells,  ///< by planes: an item is in each cell through which it passes, as in a kd-tree
};

/// Build parameters. Costs are relative to each other.
struct TreeSettings {
    Division by = Division::boxes;
    double node_cost = 1;       ///< of testing a ray against the boxes of a node
    double group_cost = 1;      ///< of testing a group of items
    double reference_cost = 0;  ///< of each additional cell that an item is in
    int group = 8;              ///< number of items of a leaf that are tested at once
};

/// Reference in a slot of a node. Rays wait for the address of the next node, so a reference to a
/// node is its offset divided by eight, without any tag bits set.
class TreeChild {
public:
    static constexpr std::uint32_t node_size = 7 * 32;

    static TreeChild node(std::uint32_t number) { return TreeChild(number * (node_size / 8)); }
    static TreeChild frame(std::uint32_t number) { return TreeChild(number << 2 | frame_kind); }
    /// `place` is the index of the leaf's item count, which its items follow: in words, or in
    /// groups of four words once the tree is packed.
    static TreeChild leaf(std::size_t place) {
        return TreeChild(static_cast<std::uint32_t>(place) << 1 | leaf_kind);
    }

    TreeChild() = default;

    bool is_leaf() const { return (bits_ & leaf_kind) != 0; }
    bool is_frame() const { return (bits_ & (leaf_kind | frame_kind)) == frame_kind; }
    bool is_node() const { return (bits_ & (leaf_kind | frame_kind)) == 0; }
    std::uint32_t node() const { return bits_ / (node_size / 8); }
    /// Offset in bytes.
    std::size_t node_place() const { return std::size_t{bits_} * 8; }
    std::uint32_t frame() const { return bits_ >> 2; }
    std::size_t leaf() const { return bits_ >> 1; }

    bool operator==(const TreeChild&) const = default;

private:
    static constexpr std::uint32_t leaf_kind = 1, frame_kind = 2;
    explicit TreeChild(std::uint32_t bits) : bits_(bits) {}

    std::uint32_t bits_;  // uninitialised, because stacks of them are long
};

/// Eight boxes relative to the frame's origin, and their contents. The lower ends of unused slots
/// are infinite.
struct alignas(32) TreeNode {
    static constexpr std::size_t width = 8;
    using Row = std::array<float, width>;

    // The children lie between the ends of the boxes, and so in a cache line that is fetched before
    // it is known which of them are needed.
    std::array<Row, 3> low;  ///< for each axis
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

/// A part of the tree with its own coordinate origin.
struct TreeFrame {
    Vec3 origin;         ///< the centre
    double reach;        ///< maximum distance from it along any axis
    std::uint32_t root;  ///< index of the root node

    bool operator==(const TreeFrame&) const = default;
};

/// A leaf whose box a ray meets.
struct TreeLeaf {
    std::span<const std::uint32_t> items;  ///< at most 8, in ascending order
    /// The words that WideTree::pack() stored for the items; null in a tree that is not packed.
    const std::uint32_t* pack;
    double entry;  ///< approximate ray parameter of the entry into the leaf's box, or of the start
                   ///< of the range
};

/// Data to be stored beside the items of leaves. Called from several threads.
struct LeafPacks {
    /// Returns the number of words.
    std::function<std::size_t(std::span<const std::uint32_t> items)> size;
    /// Fills in the words; `box` bounds the items.
    std::function<void(std::span<const std::uint32_t> items, const Box& box,
                       std::span<std::uint32_t> words)>
        fill;
};

class WideTree {
public:
    /// Maximum number of levels of nodes.
    static constexpr int depth_limit = 32;
    /// Limit of the number of items, exclusive, which the references to leaves and nodes impose.
    static constexpr std::uint32_t item_limit = 1u << 28;

    /// Makes a tree without items, which no ray meets.
    WideTree() = default;

    /// Calls visit(const TreeLeaf&, Interval& range) -> bool, or visit(std::span<const
    /// std::uint32_t> items, Interval& range), for each leaf whose box the ray meets within the
    /// range, nearer ones first where boxes do not overlap. visit may lower range.max after a hit;
    /// leaves behind it are skipped. If visit returns true, traversal stops and returns true. An
    /// item of several leaves may be visited several times.
    template <class Visit>
    bool traverse(const Ray& ray, Interval range, Visit&& visit) const {
        const auto own = as_leaf_visit(visit);
        return (!endless_.empty() && visit_endless(range, own)) ||
               (!frames_.empty() && walk(frames_[0], ray, range, own));
    }

    /// The same for occlusion tests: visits first the boxes that are likeliest to occlude the ray,
    /// relative to their number of steps. visit must not change the range. Any item may be visited
    /// several times.
    template <class Visit>
    bool traverse_likely(const Ray& ray, Interval range, Visit&& visit) const {
        const auto own = as_leaf_visit(visit);
        return (!endless_.empty() && visit_endless(range, own)) ||
               (!frames_.empty() &&
                (visit_foremost(ray, range, own) || walk_likely(frames_[0], ray, range, own)));
    }

    /// Bounds of all items with finite boxes.
    const Box& bounds() const { return bounds_; }
    std::span<const TreeNode> nodes() const { return nodes_; }
    std::span<const TreeFrame> frames() const { return frames_; }
    /// Calls use(number, frame, level) for each node, parents before children; the root's level is
    /// 1.
    void for_each_node(
        FunctionRef<void(std::uint32_t number, const TreeFrame&, int level)> use) const;
    /// Returns the items of a child that is a leaf.
    std::span<const std::uint32_t> items(TreeChild leaf) const;
    /// Leaves that occlusion rays visit first: large items, which occlude many rays. Their items
    /// are in the tree as well.
    std::span<const TreeChild> early_occluders() const { return foremost_; }
    /// Items whose boxes are not finite: in no leaf, and visited by every ray.
    std::span<const std::uint32_t> endless() const { return endless_; }
    const TreeSettings& settings() const { return settings_; }
    std::size_t memory_bytes() const;

    /// Stores data beside the items of each leaf. May be called once. threads = 0 means one per
    /// core.
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
    std::vector<TreeFrame> frames_;  ///< the first is that of the root
    std::vector<TreeNode> nodes_;
    /// The number of items of each leaf, followed by the items; empty once packed. The first leaf
    /// has no items.
    std::vector<std::uint32_t> leaves_;
    /// The same with the packed data.
    std::vector<std::uint32_t> packs_;
    std::vector<TreeChild> foremost_;
    std::vector<std::uint32_t> endless_;
    TreeSettings settings_;
};

}  // namespace candelabra
