// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_map.h"

#include <limits>
#include <numbers>

namespace candelabra {

namespace {

/// Maximum distance of a surface from the plane of a photon's disc, in radii: discs may lie on
/// balls.
constexpr double off_plane = 0.5;
/// Minimum cosine between the surface's normal and the photon's.
constexpr double alike_normals = 0.5;

/// Minimum number of photons from which their density can be estimated.
constexpr std::size_t telling_photons = 8;
/// Factor by which a group's discs may exceed the radius estimated from that group alone.
constexpr double above_own = 1.5;
/// Sets the radii of a group from the density of its photons and from the radius of the group that
/// contains it. Returns the group's radius.
double set_disc_radii(std::span<Photon> photons, double radius, const DiscRule& rule) {
    const PhotonGroup group = group_of(photons);
    // A disc of this radius holds `wanted` photons if one of radius `half` holds half of the group.
    const double by_itself =
        group.half * std::sqrt(2 * rule.wanted / static_cast<double>(photons.size()));
    radius = std::fmin(radius, std::isfinite(radius) ? above_own * by_itself : by_itself);
    set_radii(photons, group, radius, rule);
    return radius;
}

}  // namespace

double photon_density(const Photon& photon, const Vec3& point, const Vec3& normal) {
    const Vec3 offset = point - photon.position;
    const double radius = photon.radius, radius2 = radius * radius;
    const double away2 = dot(offset, offset);
    if (away2 >= radius2) return 0;
    const Vec3 own(photon.normal);
    const double height = dot(offset, own);
    if (std::abs(height) > off_plane * radius) return 0;
    if (std::abs(dot(own, normal)) < alike_normals) return 0;
    const double within2 = away2 - height * height;
    return 2 * (1 - within2 / radius2) / (std::numbers::pi * radius2);
}

PhotonMap::PhotonMap(std::vector<Photon> photons, const DiscRule& rule) {
    const double first = rule.radius > 0 ? rule.radius : rule.unknown;
    for (Photon& photon : photons) photon.radius = static_cast<float>(rule.shrunk * first);
    tree_ = {std::move(photons), std::numeric_limits<double>::infinity(),
             [&](std::span<Photon> group, double radius) {
                 const std::size_t count = group.size();
                 const bool tells =
                     count >= telling_photons &&
                     (static_cast<double>(count) <= rule.wanted || count < 2 * telling_photons);
                 return tells ? set_disc_radii(group, radius, rule) : radius;
             }};
}

}  // namespace candelabra
