// SPDX-License-Identifier: GPL-3.0-or-later
// All luminaires in one compact hierarchy, with their strengths laid end to end: clusters of them
// for the light octree's cuts, and the luminaires that a line hits for the renderer. It takes 88
// bytes per luminaire. Luminaires of an instance are one unit, which refers to a tree that all
// instances of the kind share, and takes some 130 bytes. Immutable once built.
#pragma once

#include "base/function_ref.h"
#include "base/weighted_index.h"
#include "lighting/choosable_lights.h"

#include <array>
#include <limits>

namespace candelabra {

/// A node: the bounding box of its luminaires, in single precision from the tree's origin, and
/// their combined emission.
struct LightTreeNode {
    std::array<float, 3> low, high;
    /// Mean axis of the flat luminaires, of length 127 if all are parallel.
    std::array<std::int8_t, 3> axis{};
    std::uint8_t evenness = 255;   ///< see LightProxy; in units of 1/255
    std::uint32_t first_half = 0;  ///< units in the first half; 0: it is a single unit
    std::array<std::int8_t, 3> bent_normal{};  ///< see LightProxy; in units of 1/254
};
static_assert(sizeof(LightTreeNode) == 36);

/// A node with the luminaires below it, which are consecutive in the tree's order.
struct LightCluster {
    static constexpr std::uint32_t no_copy = ~std::uint32_t{0};

    std::uint32_t node = 0;  ///< of the tree, or of that of the copy
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t copy = no_copy;  ///< the copy that it is a part of, or all of

    bool is_copied() const { return copy != no_copy; }
    bool holds(std::uint32_t place) const { return place - first < count; }
};

class LightTree {
public:
    LightTree() = default;
    /// `threads`: 0: one per core; the result does not depend on it.
    explicit LightTree(const ChoosableLights&, int threads = 1);

    std::uint32_t lights() const { return lights_; }
    LightCluster root() const { return whole({0, 0, lights_}); }
    /// Returns the two halves of a cluster of more than one luminaire.
    std::pair<LightCluster, LightCluster> halves(const LightCluster&) const;

    /// Has the halves of a cluster fetched from memory, which takes longer than to weigh them.
    void fetch_halves(const LightCluster&) const;

    LightIndex light(std::uint32_t place) const {
        return copies_.empty() ? order_[place] : light_of_unit(place);
    }
    std::uint32_t place_of(LightIndex light) const {
        return copies_.empty() ? place_of_[light] : place_in_unit(light);
    }

    /// The cluster as one luminaire: a sphere around all of it.
    LightProxy light_proxy(const LightCluster& c) const { return light_proxy(c, intensity(c)); }
    /// The same where the cluster's intensity() is known.
    LightProxy light_proxy(const LightCluster&, double intensity) const;
    Box box(const LightCluster&) const;
    /// Falloff of a cluster; null if it has a light that falls off with the square of the distance.
    const Falloff* falloff(const LightCluster& c) const {
        return c.is_copied() || c.node < first_falling_ ? nullptr
                                                        : &falloffs_[c.node - first_falling_];
    }
    /// All lights that fall off with the square of the distance. They are apart from the others:
    /// if there are both, these are the first half of the root.
    LightCluster by_square_law() const;
    bool has_both_laws() const { return !falloffs_.empty() && first_falling_ > 0; }

    /// share(): fraction of a cluster's strength that one of its luminaires has. draw(): a
    /// luminaire sampled by these fractions, for u in [0, 1). Every luminaire that is not dark has
    /// some share. Precondition: the cluster is not dark.
    double share(const LightCluster&, std::uint32_t place) const;
    std::uint32_t draw(const LightCluster&, double u) const;
    bool dark(const LightCluster&) const;
    /// Sum of the luminaires' intensities: see LightBounds.
    double intensity(const LightCluster&) const;

    /// Calls visit(LightIndex) for all luminaires whose box the ray may hit, in any order.
    template <class Visit>
    void along(const Vec3& origin, const Vec3& direction, Visit&& visit) const;

    std::size_t memory_bytes() const;

private:
    static constexpr int depth_limit = 128;
    static constexpr std::uint32_t no_copy = LightCluster::no_copy;

    /// The cluster itself; that of a copy if its node is one.
    LightCluster whole(const LightCluster& c) const {
        return copies_.empty() || nodes_[c.node].first_half > 0 ? c : whole_copy(c);
    }
    LightCluster whole_copy(const LightCluster&) const;
    std::pair<LightCluster, LightCluster> halves_among_copies(const LightCluster&) const;
    /// The part of a copy as a cluster of its own tree.
    LightCluster within(const LightCluster& c) const {
        return {c.node, c.first - copy_begin_[c.copy], c.count};
    }
    std::uint32_t unit_at(std::uint32_t place) const;
    LightIndex light_of_unit(std::uint32_t place) const;
    std::uint32_t place_in_unit(LightIndex) const;
    LightProxy proxy_of_copy(const LightCluster&, double intensity) const;

    std::uint64_t strength_before(const LightCluster&) const;
    std::uint64_t strength(const LightCluster&) const;

    std::vector<LightTreeNode> nodes_;  ///< depth first
    std::vector<Falloff> falloffs_;     ///< of the nodes below one whose lights all have one
    std::uint32_t first_falling_ = std::numeric_limits<std::uint32_t>::max();  ///< that node
    std::vector<double> intensities_;   ///< of the nodes, if their range is very wide; else empty
    std::uint32_t lights_ = 0;
    // A unit is a light, or all lights of a copy. Leaves of the tree are units.
    std::vector<LightIndex> order_;        ///< the first light of each unit, in the tree's order
    std::vector<std::uint32_t> place_of_;  ///< of each unit in that order
    WeightedIndex strengths_;              ///< of the units in the tree's order
    // Empty if there are no copies: then units are lights.
    std::vector<LightCopy> copies_;
    std::vector<std::uint32_t> copy_begin_;  ///< first place of each copy
    std::vector<LightIndex> unit_lights_;    ///< the first light of each unit, ascending
    std::vector<std::uint32_t> unit_begin_;  ///< first place of each, in the tree's order
    std::vector<std::uint32_t> copy_of_;     ///< in that order; no_copy for lights
    /// Per node: number of luminaires in the first half; of a leaf, its unit in the tree's order.
    std::vector<std::uint32_t> half_places_;
    double unit_ = 0;           ///< intensity of one place of strengths_
    Vec3 origin_ = Vec3(0);
    double size_ = 0;  ///< greatest coordinate of a luminaire relative to the origin

    friend class LightTreeBuilder;
};

inline std::pair<LightCluster, LightCluster> LightTree::halves(const LightCluster& c) const {
    if (!copies_.empty()) return halves_among_copies(c);
    // A cluster of n luminaires has 2n - 1 nodes, depth first.
    const std::uint32_t half = nodes_[c.node].first_half;
    return {{c.node + 1, c.first, half}, {c.node + 2 * half, c.first + half, c.count - half}};
}

inline void LightTree::fetch_halves(const LightCluster& c) const {
    if (c.is_copied()) return copies_[c.copy].lights->fetch_halves(within(c));
    const LightTreeNode* const first = &nodes_[c.node] + 1;
    const std::uint32_t half = nodes_[c.node].first_half;
    if (half == 0) return;
    const LightTreeNode* const second = first + (2 * half - 1);
    // A node may lie across the border of two lines.
    for (const LightTreeNode* const node : {first, second}) {
        __builtin_prefetch(node);
        __builtin_prefetch(node->bent_normal.data());
    }
    if (copies_.empty()) strengths_.fetch(c.first + half - 1);
}

inline LightCluster LightTree::by_square_law() const {
    if (falloffs_.empty()) return root();
    return has_both_laws() ? halves(root()).first : LightCluster();
}

/// A ray that tests nodes in single precision, with margins for all rounding.
class LightTreeRay {
public:
    LightTreeRay(const Vec3& from, const Vec3& direction, double size) {
        const double margin = 4e-7 * (max_abs_component(from) + size);
        for (int axis = 0; axis < 3; ++axis) {
            low_[axis] = static_cast<float>(from[axis] + margin);
            high_[axis] = static_cast<float>(from[axis] - margin);
            const double d = direction[axis];
            inverse_[axis] = static_cast<float>(1 / (std::abs(d) > 1e-18 ? d : 1e-18));
        }
    }

    bool meets(const LightTreeNode& node) const {
        const Four a = (Four{node.low[0], node.low[1], node.low[2], 0} - low_) * inverse_;
        const Four b = (Four{node.high[0], node.high[1], node.high[2], 0} - high_) * inverse_;
        const Four in = a < b ? a : b, out = a < b ? b : a;
        const float enter = std::max(std::max(in[0], in[1]), std::max(in[2], 0.0f));
        const float leave = std::min(std::min(out[0], out[1]), out[2]);
        return enter <= leave * (1 + 1e-6f);
    }

private:
    using Four [[gnu::vector_size(16)]] = float;
    Four low_{}, high_{}, inverse_{};
};

template <class Visit>
void LightTree::along(const Vec3& origin, const Vec3& direction, Visit&& visit) const {
    if (nodes_.empty()) return;
    struct Part {
        std::uint32_t node, unit;  ///< the first one of its units
    };
    const auto visit_unit = [&](std::uint32_t unit) {
        const LightIndex first = order_[unit];
        if (copies_.empty() || copy_of_[unit] == no_copy) return visit(first);
        const LightCopy& copy = copies_[copy_of_[unit]];
        const auto visit_copied = [&](LightIndex light) { visit(first + light); };
        copy.lights->along(copy.place->inverse_point(origin),
                           copy.place->inverse_direction(direction),
                           FunctionRef<void(LightIndex)>(visit_copied));
    };
    const LightTreeRay ray(origin - origin_, direction, size_);
    std::array<Part, depth_limit> waiting;
    std::size_t count = 0;
    Part here{0, 0};
    if (!ray.meets(nodes_[0])) return;
    for (;;) {
        const std::uint32_t half = nodes_[here.node].first_half;
        if (half == 0) {
            visit_unit(here.unit);
        } else {
            const Part first{here.node + 1, here.unit},
                second{here.node + 2 * half, here.unit + half};
            const bool in_first = ray.meets(nodes_[first.node]),
                       in_second = ray.meets(nodes_[second.node]);
            if (in_first) {
                if (in_second) waiting[count++] = second;
                here = first;
                continue;
            }
            if (in_second) {
                here = second;
                continue;
            }
        }
        if (count == 0) return;
        here = waiting[--count];
    }
}

/// Calls use(LightIndex) for each light that is in no copy.
template <class Use>
void for_single_lights(const ChoosableLights& lights, Use use) {
    LightIndex light = 0;
    for (const LightCopy& copy : lights.copies()) {
        for (; light < copy.first; ++light) use(light);
        light += copy.lights->lights();
    }
    for (; light < lights.size(); ++light) use(light);
}

}  // namespace candelabra
