// SPDX-License-Identifier: GPL-3.0-or-later
// Photons between surfaces: each lights a small ball of the media around it. A ray of the eye gets
// the light of all balls that it goes through, as if each were a disc across the ray (Jarosz,
// Zwicker and Jensen, "The Beam Radiance Estimate for Volumetric Photon Mapping", 2008).
#pragma once

#include "base/ray.h"
#include "transport/photon_tree.h"

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
    const std::vector<Photon>& photons() const { return tree_.photons(); }

    /// Calls use(photon, distance, squared distance from the ray) for those whose ball the ray goes
    /// through with its middle beside the ray, from its origin to so far; always in the same order.
    /// The ray's direction is a unit vector.
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
