// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_tree.h"

#include "base/order.h"

namespace candelabra {

namespace {

/// Photons farther from the group's centre than this multiple of the median distance are outliers.
constexpr double straying = 3;

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    put_nth(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

PhotonGroup group_of(std::span<const Photon> photons) {
    PhotonGroup group;
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

void set_radii(std::span<Photon> photons, const PhotonGroup& group, double usual,
               const DiscRule& rule) {
    for (Photon& photon : photons) {
        const double away = length(photon.position - group.middle);
        const double strays = group.half > 0 ? away / (straying * group.half) : 1;
        const double own = rule.radius > 0 ? rule.radius : usual * std::fmax(1, strays);
        photon.radius = static_cast<float>(rule.shrunk * (own > 0 ? own : rule.unknown));
    }
}

Box PhotonTree::box_of_leaf(std::uint32_t first, std::uint32_t last) const {
    Box around;
    for (std::uint32_t i = first; i < last; ++i) {
        const Vec3 room(photons_[i].radius);
        around = join(around, Box{photons_[i].position - room, photons_[i].position + room});
    }
    return around;
}

std::uint32_t PhotonTree::halve(std::uint32_t first, std::uint32_t last) {
    Box places;
    for (std::uint32_t i = first; i < last; ++i) places = join(places, photons_[i].position);
    const Vec3 size = places.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = first + (last - first) / 2;
    const auto place = [&](std::uint32_t i) { return photons_.begin() + i; };
    put_nth(place(first), place(half), place(last),
            [&](const Photon& a, const Photon& b) { return a.position[axis] < b.position[axis]; });
    return half;
}

}  // namespace candelabra
