// SPDX-License-Identifier: GPL-3.0-or-later
// Several shapes as one solid: unions, intersections, differences, merges, with clipping and
// bounding objects, nested to any depth. The leaves are shapes in their places; the nodes above
// them say how they are combined. As in POV-Ray, a point of a leaf's surface belongs to the whole
// when it is inside every other part of each intersection around it, and outside every other part
// of each merge. The world and the functions of the language ask it; it knows no textures.
#pragma once

#include "base/function_ref.h"
#include "base/handle.h"
#include "base/transform.h"
#include "index/settings.h"
#include "index/spatial_splits.h"
#include "shape/built_shape.h"

#include <cstdint>
#include <optional>

namespace candelabra {

/// How the parts of a node make one solid.
enum class Combination : std::uint8_t {
    together,  ///< inside any
    common,    ///< inside all
    merged,    ///< inside any; surface within others is left out
};

/// A leaf or a node of a composite that is being built.
struct PartRef {
    std::uint32_t index = 0;
    bool leaf = false;
    bool clips = false;  ///< it only cuts the others: none of its own surface is seen
};

struct CompositeLeaf {
    BuiltShape shape;
    Handle<Transform> transform = nullptr;  ///< null: none
    bool inverse = false;                   ///< inside and outside are swapped
    bool turned = false;                    ///< normals point to the other side
};

class Composite {
public:
    /// A point of the surface, in the space of the whole.
    struct Meeting {
        double t = 0;
        Vec3 normal = Vec3(0);  ///< unit; of inverse leaves it points to their inside
        std::uint32_t leaf = 0;
        std::uint32_t part = 0;  ///< of the leaf: see Crossing
    };
    /// Which leaves to look at.
    using Wanted = FunctionRef<bool(std::uint32_t leaf)>;

    /// The nearest point of the surface in the range.
    std::optional<Meeting> first(const Ray&, const Interval&, Wanted) const;
    /// All points of the surface in the range, in any order.
    void all(const Ray&, const Interval&, Wanted, FunctionRef<void(const Meeting&)> take) const;

    bool inside(const Vec3&) const;

    /// Around all surface that can be seen; infinite when some has no end.
    const Box& bounds() const { return bounds_; }
    /// Around all points inside; infinite when there are some everywhere.
    const Box& inside_bounds() const { return inside_bounds_; }
    const CompositeLeaf& leaf(std::uint32_t i) const { return leaves_[i]; }
    std::size_t leaf_count() const { return leaves_.size(); }
    /// Around the surface of one leaf, as far as it can be seen.
    const Box& leaf_bounds(std::uint32_t i) const { return seen_[i]; }

private:
    friend class CompositeBuilder;

    /// What is known of a part without asking it: where it is not `outside`.
    struct Region {
        Box box;
        bool outside = false;  ///< what inside() is everywhere but in the box
    };
    struct Part {
        PartRef ref;
        Region region;
    };
    static constexpr std::uint32_t nothing = ~0u;

    struct Node {
        Combination how = Combination::together;
        std::uint32_t parent = nothing;
        std::uint32_t limit = nothing;  ///< in limits_: rays that miss it see nothing of this node
        /// Parts that decide the answer also outside of their boxes, then the others.
        std::vector<Part> always, boxed;
        WideTree index;  ///< over the boxes of `boxed`; without nodes when they are few
        /// Half spaces that all of the node lies in, with unit normals: what each ray is cut to
        /// before any part is asked.
        std::vector<Plane> cuts;
    };

    bool inside_part(const Part&, const Vec3&) const;
    /// Whether the point is inside the node, one part of it left aside.
    bool inside_node(const Node&, const Vec3&, const PartRef* aside) const;
    bool seen_at(std::uint32_t leaf, const Vec3&) const;
    bool within_limits(std::uint32_t leaf, const Ray&) const;
    bool meets(const Ray&) const;
    /// The part of a ray that lies in the half spaces around a leaf. Leaves come in turn, and many
    /// have the same around them, for which it is computed once.
    struct Cut {
        std::uint32_t node = nothing;
        Interval left = {-std::numeric_limits<double>::infinity()};
    };
    const Interval& cut(std::uint32_t leaf, const Ray&, Cut& last) const;
    template <class Take>
    void meet_leaf(std::uint32_t leaf, const Ray&, const Interval& range, const Interval& seen,
                   Take) const;

    std::vector<CompositeLeaf> leaves_;
    std::vector<std::uint32_t> parents_;  ///< of the leaves
    std::vector<std::uint32_t> cut_by_;   ///< nodes around the leaves that have cuts, or nothing
    std::vector<Box> seen_;               ///< of the leaves; empty for those that only clip
    std::vector<Node> nodes_;
    std::vector<Handle<Composite>> limits_;
    PartRef root_;
    bool limited_ = false;
    std::vector<std::uint32_t> apart_;  ///< leaves with surface without end; all when they are few
    WideTree tree_;                     ///< over the others
    Box bounds_, inside_bounds_;
};

/// Makes a composite from the leaves up.
class CompositeBuilder {
public:
    /// Many parts are found by the index.
    explicit CompositeBuilder(const RayIndex& index = {}) : index_(index) {}

    PartRef add(CompositeLeaf);
    /// Rays that miss `limit` see nothing of the node; null: none.
    PartRef add(Combination, std::vector<PartRef> parts, Handle<Composite> limit = nullptr);
    /// The builder is used up.
    Composite finish(PartRef root);

private:
    Composite::Region region_of(const PartRef&) const;
    void settle(std::uint32_t node);
    void settle_all(std::uint32_t node);
    void show(const PartRef&, const Box& within);

    WideTree tree_of(std::span<const Box>, const ItemPart&) const;

    RayIndex index_;
    Composite made_;
    std::vector<std::vector<PartRef>> parts_;  ///< of the nodes
    std::vector<Composite::Region> leaf_regions_, node_regions_;
};

}  // namespace candelabra
