// SPDX-License-Identifier: GPL-3.0-or-later
// Several shapes as one solid: unions, intersections, differences and merges, with clipping and
// bounding objects, nested to any depth. The leaves are placed shapes; the nodes above them say how
// they are combined. As in POV-Ray, a point of a leaf's surface belongs to the whole when it is
// inside every other part of each intersection around it, and outside every other part of each
// merge. Used by the world and by functions of the language; it knows no textures.
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

/// How the parts of a node form one solid.
enum class Combination : std::uint8_t {
    together,  ///< inside any
    common,    ///< inside all
    merged,    ///< inside any; surface within others is left out
};

/// Reference to a leaf or a node of a composite under construction.
struct PartRef {
    std::uint32_t index = 0;
    bool leaf = false;
    bool clips = false;  ///< only clips the others: none of its own surface is visible
};

struct CompositeLeaf {
    BuiltShape shape;
    Handle<Transform> transform = nullptr;  ///< null: identity
    bool inverse = false;                   ///< inside and outside are swapped
    bool turned = false;                    ///< normals point to the opposite side
};

class Composite {
public:
    /// A point of the surface, in the space of the whole.
    struct Meeting {
        double t = 0;
        Vec3 normal = Vec3(0);  ///< unit; for inverse leaves it points to their inside
        std::uint32_t leaf = 0;
        std::uint32_t part = 0;  ///< of the leaf: see Crossing
    };
    /// Filter of the leaves to test.
    using Wanted = FunctionRef<bool(std::uint32_t leaf)>;

    /// Returns the nearest point of the surface in the range.
    std::optional<Meeting> first(const Ray&, const Interval&, Wanted) const;
    /// Passes all points of the surface in the range to `take`, in any order.
    void all(const Ray&, const Interval&, Wanted, FunctionRef<void(const Meeting&)> take) const;

    bool inside(const Vec3&) const;
    /// Whether rays may pass between inside and outside other than through a visible surface,
    /// because the whole or a part of it is clipped or bounded, or meet surfaces within it, because
    /// parts of it overlap; provided that the leaves are closed.
    bool has_openings() const { return clipped_ || limited_ || overlaps_; }

    /// Bounds of the visible surface; infinite when part of it is unbounded.
    const Box& bounds() const { return bounds_; }
    /// Bounds of all points inside; infinite when the inside is unbounded.
    const Box& inside_bounds() const { return inside_bounds_; }
    const CompositeLeaf& leaf(std::uint32_t i) const { return leaves_[i]; }
    std::size_t leaf_count() const { return leaves_.size(); }
    /// Bounds of the visible surface of one leaf.
    const Box& leaf_bounds(std::uint32_t i) const { return seen_[i]; }

private:
    friend class CompositeBuilder;

    /// The box of a part outside of which inside() is known without testing the part.
    struct Region {
        Box box;
        bool outside = false;  ///< result of inside() everywhere outside the box
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
        /// Parts that decide the result even outside their boxes, and the other parts.
        std::vector<Part> always, boxed;
        WideTree index;  ///< over the boxes of `boxed`; without nodes when they are few
        /// Half spaces that contain the whole node, with unit normals. Each ray is clipped to them
        /// before any part is tested.
        std::vector<Plane> cuts;
    };

    bool inside_part(const Part&, const Vec3&) const;
    /// Whether the point is inside the node, with one of its parts ignored.
    bool inside_node(const Node&, const Vec3&, const PartRef* aside) const;
    bool seen_at(std::uint32_t leaf, const Vec3&) const;
    bool within_limits(std::uint32_t leaf, const Ray&) const;
    bool meets(const Ray&) const;
    /// The part of a ray in the half spaces around a leaf. Leaves are tested in sequence, and many
    /// share their half spaces, for which it is computed once.
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
    std::vector<std::uint32_t> cut_by_;   ///< nearest node with cuts around each leaf, or `nothing`
    std::vector<Box> seen_;               ///< of the leaves; empty for leaves that only clip
    std::vector<Node> nodes_;
    std::vector<Handle<Composite>> limits_;
    PartRef root_;
    bool limited_ = false, clipped_ = false, overlaps_ = false;
    std::vector<std::uint32_t> apart_;  ///< leaves with unbounded surface; all when they are few
    WideTree tree_;                     ///< over the other leaves
    Box bounds_, inside_bounds_;
};

/// Builds a composite bottom-up.
class CompositeBuilder {
public:
    /// `index` configures the index that large numbers of parts are searched with.
    explicit CompositeBuilder(const RayIndex& index = {}) : index_(index) {}

    PartRef add(CompositeLeaf);
    /// Rays that miss `limit` see nothing of the node; null: no limit.
    PartRef add(Combination, std::vector<PartRef> parts, Handle<Composite> limit = nullptr);
    /// Returns the composite; the builder must not be used afterwards.
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
