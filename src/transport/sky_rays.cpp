// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/sky_rays.h"

#include "lighting/draw.h"
#include "luminaire/luminaire.h"

#include <cstdint>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Number of directions that estimate the light of the sky.
constexpr std::uint32_t tried_directions = 256;
/// Number of trials that find which starts matter; a multiple of the cells of a guide.
constexpr std::size_t trials = 32 * StartTrials::cells;
constexpr std::uint64_t stream_of_sky = 0x5c9;

}  // namespace

SkyRays::SkyRays(const World& world, const LitRegion& region) : world_(world), region_(region) {
    if (world.sky.light.empty()) return;
    double sum = 0;
    for (std::uint32_t i = 0; i < tried_directions; ++i) {
        const Key key{0, i, 0, 0};
        const auto drawn =
            world.sky.light.draw({uniform(key, Purpose::sky_u), uniform(key, Purpose::sky_v)});
        sum += luminance(abs(world.sky_radiance(drawn.direction))) / (pi * drawn.density);
    }
    power_ = sum / tried_directions * pi * region.radius * region.radius;
}

SkyRays::Drawn SkyRays::from(const Vec2& direction, const Vec2& place) const {
    const auto [towards, density] = world_.sky.light.draw(direction);
    const Vec3 aside = point_about_disc(towards, region_.radius, place);
    const double area = area_about_disc(length(aside), region_.radius);
    return {{region_.centre + aside + region_.upstream * towards, -towards},
            world_.sky_radiance(towards) * (area / (pi * density))};
}

SkyRays::Drawn SkyRays::draw(const Key& key) const {
    const StartGuide::Drawn direction = directions_.draw(
                                {uniform(key, Purpose::sky_u), uniform(key, Purpose::sky_v)}),
                            place = places_.draw(place_on_light(key));
    Drawn drawn = from(direction.place, place.place);
    drawn.power *= direction.factor * place.factor;
    return drawn;
}

void SkyRays::learn(FunctionRef<double(const Drawn&, const Key&)> worth) {
    StartTrials directions, places;
    for (std::size_t i = 0; i < trials; ++i) {
        const Key key{stream_of_sky, static_cast<std::uint32_t>(i), 0, 0};
        // All cells of the places for each of the directions, which go through their cells slowly.
        const std::size_t slowly = i / (trials / StartTrials::cells);
        const double found = worth(from(StartTrials::place(slowly, {uniform(key, Purpose::sky_u),
                                                                    uniform(key, Purpose::sky_v)}),
                                        StartTrials::place(i, place_on_light(key))),
                                   key);
        directions.add(slowly, found);
        places.add(i, found);
    }
    directions_ = StartGuide(directions);
    places_ = StartGuide(places);
}

}  // namespace candelabra
