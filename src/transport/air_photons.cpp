// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/air_photons.h"

#include <limits>
#include <numbers>

namespace candelabra {

double air_photon_density(const Photon& photon, double away2) {
    const double radius = photon.radius, radius2 = radius * radius;
    return away2 < radius2 ? 2 * (1 - away2 / radius2) / (std::numbers::pi * radius2) : 0;
}

// Radii are set where a group gets as small as what is wanted in a ball: half of the group lies
// within a ball around its middle, and so as many as are wanted in one that is larger or smaller by
// the cube root of their number.
AirPhotonMap::AirPhotonMap(std::vector<Photon> photons, const DiscRule& rule)
    : tree_(std::move(photons), std::numeric_limits<double>::infinity(),
            [&](std::span<Photon> part, double count_of_whole) {
                const auto count = static_cast<double>(part.size());
                if (count <= rule.wanted && count_of_whole > rule.wanted) {
                    const PhotonGroup group = group_of(part);
                    set_radii(part, group, group.half * std::cbrt(2 * rule.wanted / count), rule);
                }
                return count;
            }) {}

}  // namespace candelabra
