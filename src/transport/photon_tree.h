// SPDX-License-Identifier: GPL-3.0-or-later
// Photons in a bounding volume hierarchy. Each photon lights a small disc or ball around it. Used
// by the maps of photons on surfaces and of photons in the air.
#pragma once

#include "base/box.h"
#include "world/lamp.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

struct Photon {
    Vec3 position;
    glm::vec3 direction;  ///< unit direction of travel
    glm::vec3 normal;     ///< unit geometric normal of the surface; 0 in the air
    /// Colour of light times area perpendicular to the direction; in the air, also times the length
    /// of the path segment that the photon stands for.
    glm::vec3 power;
    float radius = 0;  ///< of its disc or ball
    Lamp lamp = Lamp::sky();

    bool in_air() const { return normal == glm::vec3(0); }
};

/// Sizes of the discs or balls.
struct DiscRule {
    double wanted = 60;  ///< approximate number of photons within one disc
    double shrunk = 1;   ///< factor on all radii
    double radius = 0;   ///< of all discs, before the factor `shrunk`; 0: by `wanted`
    double unknown = 1;  ///< radius where photons are too few to estimate their density
};

/// The centre and extent of a group of photons, by medians, so that outliers do not matter.
struct PhotonGroup {
    Vec3 middle = Vec3(0);
    double half = 0;  ///< distance from the centre within which half of the photons lie
};
PhotonGroup group_of(std::span<const Photon>);

/// Sets all radii to `usual`, or to the rule's radius if there is one. The radius of an outlier
/// grows with its distance from the group.
void set_radii(std::span<Photon>, const PhotonGroup&, double usual, const DiscRule&);

class PhotonTree {
public:
    PhotonTree() = default;
    /// Divides the photons in halves along the longest side of their bounding box. Before each
    /// group is divided, enter(photons, known) may set its radii; the result is passed as `known`
    /// to both halves.
    template <class Known, class Enter>
    PhotonTree(std::vector<Photon> photons, const Known& known, const Enter& enter)
        : photons_(std::move(photons)) {
        if (photons_.empty()) return;
        nodes_.reserve(2 * photons_.size() / photons_in_leaf + 1);
        divide(0, static_cast<std::uint32_t>(photons_.size()), known, enter);
    }

    /// In an order that depends only on the photons.
    const std::vector<Photon>& photons() const { return photons_; }

    /// Calls use(photon) for all photons in boxes for which meets(box) is true, in a fixed order.
    template <class Meets, class Use>
    void walk(const Meets& meets, const Use& use) const {
        for (std::size_t at = 0; at < nodes_.size();) {
            const Node& node = nodes_[at];
            if (!meets(node.box)) {
                at = node.next;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.last; ++i) use(photons_[i]);
            ++at;
        }
    }

private:
    static constexpr std::uint32_t photons_in_leaf = 6;

    /// Nodes are in depth-first order; only leaves have photons.
    struct Node {
        Box box;                 ///< around its photons' discs or balls
        std::uint32_t next = 0;  ///< the first node after the subtree of this one
        std::uint32_t first = 0, last = 0;
    };

    /// Returns the bounding box of the discs or balls of a group that is not divided.
    Box box_of_leaf(std::uint32_t first, std::uint32_t last) const;
    /// Moves half of a group before the other half. Returns the index of the first of the latter.
    std::uint32_t halve(std::uint32_t first, std::uint32_t last);

    template <class Known, class Enter>
    Box divide(std::uint32_t first, std::uint32_t last, const Known& known, const Enter& enter) {
        const std::size_t own = nodes_.size();
        nodes_.emplace_back();
        const Known here = enter(std::span(photons_).subspan(first, last - first), known);
        Box around;
        if (last - first <= photons_in_leaf) {
            nodes_[own].first = first;
            nodes_[own].last = last;
            around = box_of_leaf(first, last);
        } else {
            const std::uint32_t half = halve(first, last);
            around = divide(first, half, here, enter);
            around = join(around, divide(half, last, here, enter));
        }
        nodes_[own].box = around;
        nodes_[own].next = static_cast<std::uint32_t>(nodes_.size());
        return around;
    }

    std::vector<Photon> photons_;
    std::vector<Node> nodes_;
};

}  // namespace candelabra
