// SPDX-License-Identifier: GPL-3.0-or-later
// Photons between surfaces: each lights a small ball of the media around it. A ray of the eye gets
// the light of all balls that it goes through, as if each were a disc across the ray (Jarosz,
// Zwicker and Jensen, "The Beam Radiance Estimate for Volumetric Photon Mapping", 2008).
#pragma once

#include "base/ray.h"
#include "transport/photon_map.h"

namespace candelabra {

/// The share of its power per area that a photon gives a ray which passes it so far away, squared:
/// most in the middle of its ball (Epanechnikov's kernel).
double air_photon_density(const Photon&, double away2);

class AirPhotonMap {
public:
    AirPhotonMap() = default;
    /// Sets the radii: where more photons are they are smaller.
    AirPhotonMap(std::vector<Photon>, const DiscRule&);

    /// In an order that depends on them only.
    const std::vector<Photon>& photons() const { return photons_; }

    /// Calls use(photon, distance, squared distance from the ray) for those whose ball the ray goes
    /// through with its middle beside the ray, from its origin to so far; always in the same order.
    /// The ray's direction is a unit vector.
    template <class Use>
    void along(const Ray& ray, double until, const Use& use) const {
        for (std::size_t at = 0; at < nodes_.size();) {
            const Node& node = nodes_[at];
            if (!is_met(node.box, ray, until)) {
                at = node.next;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.last; ++i) {
                const Vec3 offset = photons_[i].position - ray.origin;
                const double distance = dot(offset, ray.direction);
                const double radius = photons_[i].radius;
                const Vec3 beside = offset - distance * ray.direction;
                const double away2 = dot(beside, beside);
                if (distance > 0 && distance < until && away2 < radius * radius)
                    use(photons_[i], distance, away2);
            }
            ++at;
        }
    }

private:
    /// In the order of a walk that enters all of them; leaves have photons.
    struct Node {
        Box box;                 ///< around the balls
        std::uint32_t next = 0;  ///< the node after all that are in this one
        std::uint32_t first = 0, last = 0;
    };

    static bool is_met(const Box&, const Ray&, double until);
    Box divide(std::uint32_t first, std::uint32_t last, const DiscRule&);

    std::vector<Photon> photons_;
    std::vector<Node> nodes_;
};

}  // namespace candelabra
