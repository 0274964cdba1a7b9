// SPDX-License-Identifier: GPL-3.0-or-later
// Photons where they have come to surfaces: each lights a small disc around it. A hierarchy of
// boxes around the discs finds those that a point lies in. (In the air: see air_photons.h.)
#pragma once

#include "base/box.h"

#include <cstddef>
#include <cstdint>
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

/// The share of its power per area that a photon gives a point: densest in the middle of its disc
/// (Epanechnikov's kernel). 0 outside, and where the surface at the point, which has that normal,
/// is another one.
double photon_density(const Photon&, const Vec3& point, const Vec3& normal);

/// How large the discs are.
struct DiscRule {
    double wanted = 60;  ///< photons within the disc of one, about
    double shrunk = 1;   ///< by what the radius that follows from it is multiplied
    double radius = 0;   ///< of all discs instead, with `shrunk` not in it; 0: by `wanted`
    double unknown = 1;  ///< radius where photons are too few to tell
};

class PhotonMap {
public:
    PhotonMap() = default;
    /// Sets the radii: where more photons have come they are smaller.
    PhotonMap(std::vector<Photon>, const DiscRule&);

    /// In an order that depends on them only.
    const std::vector<Photon>& photons() const { return photons_; }

    /// Calls use(photon) for those whose disc may hold the point, always in the same order.
    template <class Use>
    void around(const Vec3& point, const Use& use) const {
        for (std::size_t at = 0; at < nodes_.size();) {
            const Node& node = nodes_[at];
            if (!contains(node.box, point)) {
                at = node.next;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.last; ++i) {
                const Vec3 offset = point - photons_[i].position;
                const double radius = photons_[i].radius;
                if (dot(offset, offset) < radius * radius) use(photons_[i]);
            }
            ++at;
        }
    }

private:
    /// In the order of a walk that enters all of them; leaves have photons.
    struct Node {
        Box box;                 ///< around the discs
        std::uint32_t next = 0;  ///< the node after all that are in this one
        std::uint32_t first = 0, last = 0;
    };

    Box divide(std::uint32_t first, std::uint32_t last, double radius, const DiscRule&);
    double set_radii(std::uint32_t first, std::uint32_t last, double radius, const DiscRule&);

    std::vector<Photon> photons_;
    std::vector<Node> nodes_;
};

}  // namespace candelabra
