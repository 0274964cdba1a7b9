// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_map.h"

#include <limits>
#include <numbers>

namespace candelabra {

namespace {

/// How far off the plane of a photon's disc a surface may be, in radii: discs may lie on balls.
constexpr double off_plane = 0.5;
/// Cosine between its normal and the photon's.
constexpr double alike_normals = 0.5;

/// Fewer photons do not tell how dense they lie.
constexpr std::size_t telling_photons = 8;
/// A part of some photons may lie in larger discs than it would have by itself, by this.
constexpr double above_own = 1.5;
/// Sets the radii of a group by how dense its photons lie, and by what is known of the whole that
/// they are part of. Gives what is known of the group.
double set_disc_radii(std::span<Photon> photons, double radius, const DiscRule& rule) {
    const PhotonGroup group = group_of(photons);
    // So many lie in a disc of that radius when half of the group lies in one of `half`.
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
