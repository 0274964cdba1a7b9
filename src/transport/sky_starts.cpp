// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/sky_starts.h"

#include "base/cosine_direction.h"
#include "transport/light_left.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

constexpr std::uint64_t stream_of_starts = 0x5c9;
/// Number of ways from each of the places that the camera sees, maximum number of surfaces on each
/// of them, and number of directions of the sky that are tried at each surface.
constexpr int ways_of_place = 4, places_of_way = 3, directions_of_place = 16;
/// Number of starts after which no more are looked for.
constexpr std::size_t enough_starts = 2048;

Vec3 perpendicular_part(const Vec3& v, const Vec3& axis) { return v - dot(v, axis) * axis; }

/// Adds the directions in which a place sees the sky.
void look_up(const World& world, const SeenPlace& from, const Key& key,
             std::vector<SkyStart>& found) {
    for (int i = 0; i < directions_of_place; ++i) {
        const Key own = key.part(directions_of_place, i);
        const Vec2 place{uniform(own, Purpose::sky_u), uniform(own, Purpose::sky_v)};
        const auto [direction, density] = world.sky.light.draw(place);
        const double cosine = dot(direction, from.normal);
        if (!(cosine > 0)) continue;
        const double worth = cosine / density * luminance(abs(world.sky_radiance(direction)));
        if (worth > 0 &&
            world.transmittance({from.position, direction}, from.tolerance, far_away) != Rgb(0))
            found.push_back({place, from.position, worth});
    }
}

}  // namespace

std::vector<SkyStart> sky_starts(const World& world, std::span<const SeenPlace> seen) {
    std::vector<SkyStart> found;
    std::uint32_t number = 0;
    for (int way = 0; way < ways_of_place; ++way)
        for (const SeenPlace& first : seen) {
            if (found.size() >= enough_starts) return found;
            SeenPlace from = first;
            for (int n = 0; n < places_of_way; ++n) {
                const Key key{stream_of_starts, number++, 0, 0};
                const Ray ray{from.position,
                              cosine_direction(from.normal, {uniform(key, Purpose::bounce_u),
                                                             uniform(key, Purpose::bounce_v)})};
                Hit hit;
                if (!world.first_hit(ray, from.tolerance, RayKind::gathering, hit)) break;
                const Vec3 normal = unit(hit.normal);
                from = {hit.position, dot(normal, ray.direction) > 0 ? -normal : normal,
                        hit.tolerance};
                look_up(world, from, key, found);
            }
        }
    return found;
}

SkyGuide::SkyGuide(std::span<const SkyStart> starts, const LitRegion& region, std::uint32_t across,
                   double width)
    : across_(across), cells_(std::size_t{across} * across + 1) {
    for (const SkyStart& start : starts) ++cells_[cell_of(start.direction) + 1];
    for (std::size_t i = 1; i < cells_.size(); ++i) cells_[i] += cells_[i - 1];
    std::vector<std::uint32_t> next = cells_;
    std::vector<double> worths(starts.size());
    starts_.resize(starts.size());
    for (const SkyStart& start : starts) {
        const std::uint32_t i = next[cell_of(start.direction)]++;
        const Vec3 offset = start.place - region.centre;
        starts_[i] = {offset, width * std::fmax(region.radius, length(offset))};
        worths[i] = start.worth;
    }
    weights_ = WeightedIndex(worths);
}

std::uint32_t SkyGuide::cell_of(const Vec2& direction) const {
    const auto along = [&](double x) {
        return std::min(static_cast<std::uint32_t>(x * across_), across_ - 1);
    };
    return along(direction.y) * across_ + along(direction.x);
}

SkyGuide::Drawn SkyGuide::draw(const Vec2& u) const {
    const std::uint32_t near = weights_.at_share(u.x);
    const auto behind = std::ranges::upper_bound(cells_, near);
    const auto cell = static_cast<std::uint32_t>(behind - cells_.begin()) - 1;
    return {Vec2(cell % across_ + weights_.within(near, u.x), cell / across_ + u.y) /
                static_cast<double>(across_),
            near};
}

Vec3 SkyGuide::aside(std::uint32_t near, const Vec3& direction, const Vec2& u) const {
    const Start& start = starts_[near];
    return perpendicular_part(start.offset, direction) + point_in_disc(direction, start.radius, u);
}

double SkyGuide::density(const Vec2& direction, const Vec3& towards, const Vec3& aside) const {
    const std::uint32_t cell = cell_of(direction);
    double sum = 0;
    for (std::uint32_t i = cells_[cell]; i < cells_[cell + 1]; ++i) {
        const Vec3 away = aside - perpendicular_part(starts_[i].offset, towards);
        const double area = starts_[i].radius * starts_[i].radius;
        if (dot(away, away) <= area) sum += weights_.share_of(i) / (std::numbers::pi * area);
    }
    return sum * across_ * across_;
}

}  // namespace candelabra
