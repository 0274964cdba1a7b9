// SPDX-License-Identifier: GPL-3.0-or-later
// Photons between surfaces: each lights a small ball of the media around it. A camera ray receives
// the light of all balls that it passes through, as if each were a disc across the ray (Jarosz,
// Zwicker and Jensen, "The Beam Radiance Estimate for Volumetric Photon Mapping", 2008).
#pragma once

#include "base/ray.h"
#include "transport/photon_tree.h"

namespace candelabra {

/// Fraction of a photon's power per area that a ray receives at that squared distance, by
/// Epanechnikov's kernel: it is greatest in the centre of the photon's ball.
double air_photon_density(const Photon&, double away2);

class AirPhotonMap {
public:
    AirPhotonMap() = default;
    /// Sets the radii, which are smaller where photons are denser.
    AirPhotonMap(std::vector<Photon>, const DiscRule&);

    /// In an order that depends only on the photons.
    const std::vector<Photon>& photons() const { return tree_.photons(); }

    /// Calls use(photon, distance, squared distance from the ray) for each photon whose ball the
    /// ray passes through and whose centre lies beside the ray, between its origin and `until`;
    /// always in the same order. The ray's direction is a unit vector.
    template <class Use>
    void along(const Ray& ray, double until, const Use& use) const {
        tree_.walk(
            [&](const Box& box) {
                const Interval inside = clip(ray, box, {0, until});
                return inside.min <= inside.max;
            },
            [&](const Photon& photon) {
                const Vec3 offset = photon.position - ray.origin;
                const double distance = dot(offset, ray.direction);
                const double radius = photon.radius;
                const Vec3 beside = offset - distance * ray.direction;
                const double away2 = dot(beside, beside);
                if (distance > 0 && distance < until && away2 < radius * radius)
                    use(photon, distance, away2);
            });
    }

private:
    PhotonTree tree_;
};

}  // namespace candelabra
