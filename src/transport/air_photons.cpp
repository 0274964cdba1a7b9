// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/air_photons.h"

#include <algorithm>
#include <numbers>
#include <span>

namespace candelabra {

namespace {

constexpr std::uint32_t balls_in_leaf = 6;
/// A photon that is farther from the middle of its group than so many times the distance of half of
/// the group strays: its ball grows with its distance.
constexpr double astray = 3;

/// Sets the radii of photons that lie together: half of them lie within a ball around their middle,
/// and so as many as are wanted in one that is larger or smaller by the cube root of their number.
void set_ball_radii(std::span<Photon> photons, const DiscRule& rule) {
    std::vector<double> values(photons.size());
    const auto median = [&](auto value) {
        std::ranges::transform(photons, values.begin(), value);
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::ranges::nth_element(values, middle);
        return *middle;
    };
    Vec3 middle;
    for (int axis = 0; axis < 3; ++axis)
        middle[axis] = median([&](const Photon& photon) { return photon.position[axis]; });
    const auto away = [&](const Photon& photon) { return length(photon.position - middle); };
    const double half = median(away);
    const double usual = half * std::cbrt(2 * rule.wanted / static_cast<double>(photons.size()));
    for (Photon& photon : photons) {
        const double strays = half > 0 ? std::fmax(1, away(photon) / (astray * half)) : 1;
        const double own = rule.radius > 0 ? rule.radius : usual * strays;
        photon.radius = static_cast<float>(rule.shrunk * (own > 0 ? own : rule.unknown));
    }
}

}  // namespace

double air_photon_density(const Photon& photon, double away2) {
    const double radius = photon.radius, radius2 = radius * radius;
    return away2 < radius2 ? 2 * (1 - away2 / radius2) / (std::numbers::pi * radius2) : 0;
}

AirPhotonMap::AirPhotonMap(std::vector<Photon> photons, const DiscRule& rule)
    : photons_(std::move(photons)) {
    if (photons_.empty()) return;
    nodes_.reserve(2 * photons_.size() / balls_in_leaf + 1);
    const auto count = static_cast<std::uint32_t>(photons_.size());
    if (count <= rule.wanted) set_ball_radii(photons_, rule);
    divide(0, count, rule);
}

bool AirPhotonMap::is_met(const Box& box, const Ray& ray, double until) {
    double enter = 0, leave = until;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        const double inverse = 1 / (std::abs(d) > 1e-18 ? d : 1e-18);
        const double a = (box.low[axis] - ray.origin[axis]) * inverse,
                     b = (box.high[axis] - ray.origin[axis]) * inverse;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

/// By halves along the longest side. Radii are set where a group gets as small as what is wanted in
/// a ball.
Box AirPhotonMap::divide(std::uint32_t first, std::uint32_t last, const DiscRule& rule) {
    const std::size_t own = nodes_.size();
    nodes_.emplace_back();
    const std::uint32_t count = last - first;
    Box around;
    if (count <= balls_in_leaf) {
        nodes_[own].first = first;
        nodes_[own].last = last;
        for (std::uint32_t i = first; i < last; ++i) {
            const Vec3 room(photons_[i].radius);
            around = join(around, Box{photons_[i].position - room, photons_[i].position + room});
        }
    } else {
        Box places;
        for (std::uint32_t i = first; i < last; ++i) places = join(places, photons_[i].position);
        const Vec3 size = places.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t half = first + count / 2;
        const auto place = [&](std::uint32_t i) { return photons_.begin() + i; };
        std::nth_element(
            place(first), place(half), place(last),
            [&](const Photon& a, const Photon& b) { return a.position[axis] < b.position[axis]; });
        const std::span<Photon> photons(photons_);
        for (const auto& [from, to] : {std::pair(first, half), std::pair(half, last)}) {
            if (count > rule.wanted && to - from <= rule.wanted)
                set_ball_radii(photons.subspan(from, to - from), rule);
            around = join(around, divide(from, to, rule));
        }
    }
    nodes_[own].box = around;
    nodes_[own].next = static_cast<std::uint32_t>(nodes_.size());
    return around;
}

}  // namespace candelabra
