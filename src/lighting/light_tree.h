// SPDX-License-Identifier: GPL-3.0-or-later
// All luminaires in one compact hierarchy, with their strengths laid end to end: clusters of them
// for the light octree's cuts, and the luminaires that a line hits for the renderer. It takes 88
// bytes per luminaire. Immutable once built.
#pragma once

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
    std::uint32_t first_half = 0;  ///< luminaires in the first half; 0: it is a single luminaire
    std::array<std::int8_t, 3> bent_normal{};  ///< see LightProxy; in units of 1/254
};
static_assert(sizeof(LightTreeNode) == 36);

/// A node with the luminaires below it, which are consecutive in the tree's order.
struct LightCluster {
    std::uint32_t node = 0;
    std::uint32_t first = 0;
    std::uint32_t count = 0;

    bool holds(std::uint32_t place) const { return place - first < count; }
};

class LightTree {
public:
    LightTree() = default;
    /// `threads`: 0: one per core; the result does not depend on it.
    explicit LightTree(const ChoosableLights&, int threads = 1);

    std::uint32_t lights() const { return static_cast<std::uint32_t>(order_.size()); }
    LightCluster root() const { return {0, 0, lights()}; }
    /// Returns the two halves of a cluster of more than one luminaire.
    std::pair<LightCluster, LightCluster> halves(const LightCluster&) const;

    LightIndex light(std::uint32_t place) const { return order_[place]; }
    std::uint32_t place_of(LightIndex light) const { return place_of_[light]; }

    /// The cluster as one luminaire: a sphere around all of it.
    LightProxy light_proxy(const LightCluster&) const;
    Box box(const LightCluster&) const;
    /// Falloff of a cluster; null if it has a light that falls off with the square of the distance.
    const Falloff* falloff(const LightCluster& c) const {
        return c.node < first_falling_ ? nullptr : &falloffs_[c.node - first_falling_];
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

    /// Calls visit(LightIndex) for all luminaires whose box the ray may hit, in any order.
    template <class Visit>
    void along(const Vec3& origin, const Vec3& direction, Visit&& visit) const;

    std::size_t memory_bytes() const;

private:
    static constexpr int depth_limit = 128;

    std::uint64_t strength_before(const LightCluster&) const;
    std::uint64_t strength(const LightCluster&) const;
    double intensity(const LightCluster&) const;

    std::vector<LightTreeNode> nodes_;  ///< depth first
    std::vector<Falloff> falloffs_;     ///< of the nodes below one whose lights all have one
    std::uint32_t first_falling_ = std::numeric_limits<std::uint32_t>::max();  ///< that node
    std::vector<double> intensities_;   ///< of the nodes, if their range is very wide; else empty
    std::vector<LightIndex> order_;
    std::vector<std::uint32_t> place_of_;
    WeightedIndex strengths_;   ///< in the tree's order
    double unit_ = 0;           ///< intensity of one place of strengths_
    Vec3 origin_ = Vec3(0);
    double size_ = 0;  ///< greatest coordinate of a luminaire relative to the origin

    friend class LightTreeBuilder;
};

inline std::pair<LightCluster, LightCluster> LightTree::halves(const LightCluster& c) const {
    // A cluster of n luminaires has 2n - 1 nodes, depth first.
    const std::uint32_t half = nodes_[c.node].first_half;
    return {{c.node + 1, c.first, half}, {c.node + 2 * half, c.first + half, c.count - half}};
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
    const LightTreeRay ray(origin - origin_, direction, size_);
    std::array<LightCluster, depth_limit> waiting;
    std::size_t count = 0;
    LightCluster here = root();
    if (!ray.meets(nodes_[0])) return;
    for (;;) {
        if (here.count == 1) {
            visit(order_[here.first]);
        } else {
            const auto [first, second] = halves(here);
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

}  // namespace candelabra
