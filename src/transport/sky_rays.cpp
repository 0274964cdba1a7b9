// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/sky_rays.h"

#include "lighting/draw.h"
#include "luminaire/luminaire.h"

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Number of directions that estimate the light of the sky.
constexpr std::uint32_t tried_directions = 256;
/// Fraction of the rays that lead anywhere about the region, and of those that each guide draws.
constexpr double anywhere = 0.25;
constexpr std::array<double, 2> by_guide = {0.25, 0.5};
/// Fraction of the rays that lead anywhere of which the light arrives beside the region: what far
/// ground reflects comes from a few of them.
constexpr double beside = 0.5;

}  // namespace

SkyRays::SkyRays(const World& world, const LitRegion& region, std::span<const SeenPlace> seen)
    : world_(world), region_(region) {
    if (world.sky.light.empty()) return;
    double sum = 0;
    for (std::uint32_t i = 0; i < tried_directions; ++i) {
        const Key key{0, i, 0, 0};
        const auto drawn =
            world.sky.light.draw({uniform(key, Purpose::sky_u), uniform(key, Purpose::sky_v)});
        sum += luminance(abs(world.sky_radiance(drawn.direction))) / (pi * drawn.density);
    }
    power_ = sum / tried_directions * pi * region.radius * region.radius;
    const std::vector<SkyStart> starts =
        power_ > 0 ? sky_starts(world, seen) : std::vector<SkyStart>();
    if (!starts.empty())
        guides_ = {SkyGuide(starts, region, 4, 0.3), SkyGuide(starts, region, 12, 0.125)};
}

SkyRays::Drawn SkyRays::draw(double choice, const Key& key) const {
    const Vec2 u{uniform(key, Purpose::sky_u), uniform(key, Purpose::sky_v)},
        place = place_on_light(key);
    const bool has_guides = !guides_[0].empty(), guides = has_guides && choice >= anywhere;
    const std::size_t which = choice < anywhere + by_guide[0] ? 0 : 1;
    const SkyGuide::Drawn start = guides ? guides_[which].draw(u) : SkyGuide::Drawn{u, 0};
    const auto [towards, of_direction] = world_.sky.light.draw(start.direction);
    const Vec3 aside = guides ? guides_[which].aside(start.near, towards, place)
                              : point_about_disc(towards, region_.radius, place, beside);
    double density = 1 / area_about_disc(length(aside), region_.radius, beside);
    if (has_guides) {
        density *= anywhere;
        for (std::size_t i = 0; i < guides_.size(); ++i)
            density += by_guide[i] * guides_[i].density(start.direction, towards, aside);
    }
    return {{region_.centre + aside + region_.upstream * towards, -towards},
            world_.sky_radiance(towards) / (pi * of_direction * density)};
}

}  // namespace candelabra
