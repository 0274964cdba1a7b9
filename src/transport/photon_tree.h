// SPDX-License-Identifier: GPL-3.0-or-later
// Photons, each of which lights a small space around it, in a hierarchy of boxes around these
// spaces. Used by the map of photons on surfaces and by that of photons in the air.
#pragma once

#include "base/box.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

struct Photon {
    Vec3 position;
    glm::vec3 direction;  ///< unit, in which it came
    glm::vec3 normal;     ///< unit, of the surface as it is; 0 in the air
    /// Colour of light times the area that is hit by it straight on; in the air also times the
    /// length of its way that it stands for.
    glm::vec3 power;
    float radius = 0;             ///< of its disc or ball
    std::uint32_t statement = 0;  ///< in Provenance::light_statements, that made its lamp
    bool glows = false;           ///< its lamp is a luminaire

    bool in_air() const { return normal == glm::vec3(0); }
};

/// How large the discs or balls are.
struct DiscRule {
    double wanted = 60;  ///< photons within that of one, about
    double shrunk = 1;   ///< by what the radius that follows from it is multiplied
    double radius = 0;   ///< of all instead, with `shrunk` not in it; 0: by `wanted`
    double unknown = 1;  ///< radius where photons are too few to tell
};

/// Where most photons of a group are, whatever some do that stray.
struct PhotonGroup {
    Vec3 middle = Vec3(0);
    double half = 0;  ///< distance from the middle within which half of them are
};
PhotonGroup group_of(std::span<const Photon>);

/// Sets the radii to the usual one, or by the rule instead. That of a photon that strays from its
/// group grows with its distance.
void set_radii(std::span<Photon>, const PhotonGroup&, double usual, const DiscRule&);

class PhotonTree {
public:
    PhotonTree() = default;
    /// Divides them by halves along the longest side. Before a group is divided, the whole first,
    /// enter(photons, known) may set their radii, and gives what is known of them to both halves.
    template <class Known, class Enter>
    PhotonTree(std::vector<Photon> photons, const Known& known, const Enter& enter)
        : photons_(std::move(photons)) {
        if (photons_.empty()) return;
        nodes_.reserve(2 * photons_.size() / photons_in_leaf + 1);
        divide(0, static_cast<std::uint32_t>(photons_.size()), known, enter);
    }

    /// In an order that depends on them only.
    const std::vector<Photon>& photons() const { return photons_; }

    /// Calls use(photon) for those in boxes of which meets(box) is true, always in the same order.
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

    /// In the order of a walk that enters all of them; leaves have photons.
    struct Node {
        Box box;                 ///< around their discs or balls
        std::uint32_t next = 0;  ///< the node after all that are in this one
        std::uint32_t first = 0, last = 0;
    };

    /// Around the discs or balls of a group that is not divided.
    Box box_of_leaf(std::uint32_t first, std::uint32_t last) const;
    /// Puts half of a group before the other one, and says where that one begins.
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
