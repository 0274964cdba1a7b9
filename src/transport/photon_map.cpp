// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_map.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <span>

namespace candelabra {

namespace {

constexpr std::uint32_t photons_in_leaf = 6;

/// How far off the plane of a photon's disc a surface may be, in radii: discs may lie on balls.
constexpr double off_plane = 0.5;
/// Cosine between its normal and the photon's.
constexpr double alike_normals = 0.5;

/// Fewer photons do not tell how dense they lie.
constexpr std::uint32_t telling_photons = 8;
/// A part of some photons may lie in larger discs than it would have by itself, by this.
constexpr double above_own = 1.5;
/// A photon strays from its group that is farther from the middle than this times the distance of
/// half of them; its disc grows with its distance.
constexpr double straying = 3;

Box disc_box(const Photon& photon) {
    const Vec3 room(photon.radius);
    return {photon.position - room, photon.position + room};
}

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Where most photons of a group are, whatever some do that stray.
struct Group {
    Vec3 middle = Vec3(0);
    double half = 0;  ///< distance from the middle within which half of them are
};
Group group_of(std::span<const Photon> photons) {
    Group group;
    std::vector<double> values(photons.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::transform(photons, values.begin(),
                               [&](const Photon& photon) { return photon.position[axis]; });
        group.middle[axis] = median(values);
    }
    std::ranges::transform(photons, values.begin(), [&](const Photon& photon) {
        return length(photon.position - group.middle);
    });
    group.half = median(values);
    return group;
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

PhotonMap::PhotonMap(std::vector<Photon> photons, const DiscRule& rule)
    : photons_(std::move(photons)) {
    if (photons_.empty()) return;
    nodes_.reserve(2 * photons_.size() / photons_in_leaf + 1);
    const double first = rule.radius > 0 ? rule.radius : rule.unknown;
    for (Photon& photon : photons_) photon.radius = static_cast<float>(rule.shrunk * first);
    divide(0, static_cast<std::uint32_t>(photons_.size()), std::numeric_limits<double>::infinity(),
           rule);
}

/// Radii of a group of photons by how dense these lie, and by what is known of the whole that they
/// are part of. Gives what is known of the group.
double PhotonMap::set_radii(std::uint32_t first, std::uint32_t last, double radius,
                            const DiscRule& rule) {
    const std::span<Photon> photons(photons_.data() + first, last - first);
    const Group group = group_of(photons);
    // So many lie in a disc of that radius when half of the group lies in one of `half`.
    const double by_itself =
        group.half * std::sqrt(2 * rule.wanted / static_cast<double>(photons.size()));
    radius = std::fmin(radius, std::isfinite(radius) ? above_own * by_itself : by_itself);
    for (Photon& photon : photons) {
        const double away = length(photon.position - group.middle);
        const double strays = group.half > 0 ? away / (straying * group.half) : 1;
        const double own = rule.radius > 0 ? rule.radius : radius * std::fmax(1, strays);
        photon.radius = static_cast<float>(rule.shrunk * (own > 0 ? own : rule.unknown));
    }
    return radius;
}

/// By halves along the longest side. `radius`: what is known of it from the whole.
Box PhotonMap::divide(std::uint32_t first, std::uint32_t last, double radius,
                      const DiscRule& rule) {
    const std::size_t own = nodes_.size();
    nodes_.emplace_back();
    Box places, discs;
    for (std::uint32_t i = first; i < last; ++i) places = join(places, photons_[i].position);
    const std::uint32_t count = last - first;
    if (count >= telling_photons && (count <= rule.wanted || count < 2 * telling_photons))
        radius = set_radii(first, last, radius, rule);
    if (count <= photons_in_leaf) {
        nodes_[own].first = first;
        nodes_[own].last = last;
        for (std::uint32_t i = first; i < last; ++i) {
            discs = join(discs, disc_box(photons_[i]));
        }
    } else {
        const Vec3 size = places.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t half = first + count / 2;
        const auto place = [&](std::uint32_t i) { return photons_.begin() + i; };
        std::nth_element(
            place(first), place(half), place(last),
            [&](const Photon& a, const Photon& b) { return a.position[axis] < b.position[axis]; });
        discs = divide(first, half, radius, rule);
        discs = join(discs, divide(half, last, radius, rule));
    }
    nodes_[own].box = discs;
    nodes_[own].next = static_cast<std::uint32_t>(nodes_.size());
    return discs;
}

}  // namespace candelabra
