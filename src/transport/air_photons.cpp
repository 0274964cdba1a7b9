// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/air_photons.h"

#include "base/elementary.h"

#include <limits>
#include <numbers>

namespace candelabra {

double air_photon_density(const Photon& photon, double away2) {
    const double radius = photon.radius, radius2 = radius * radius;
    return away2 < radius2 ? 2 * (1 - away2 / radius2) / (std::numbers::pi * radius2) : 0;
}

// Radii are set as soon as a group has no more photons than are wanted in a ball. Half of the group
// lies within group.half of its centre; the radius of a ball that holds the wanted number differs
// from this by the cube root of the ratio of the numbers.
AirPhotonMap::AirPhotonMap(std::vector<Photon> photons, const DiscRule& rule)
    : tree_(std::move(photons), std::numeric_limits<double>::infinity(),
            [&](std::span<Photon> part, double count_of_whole) {
                const auto count = static_cast<double>(part.size());
                if (count <= rule.wanted && count_of_whole > rule.wanted) {
                    const PhotonGroup group = group_of(part);
                    set_radii(part, group, group.half * math::cbrt(2 * rule.wanted / count), rule);
                }
                return count;
            }) {}

}  // namespace candelabra
