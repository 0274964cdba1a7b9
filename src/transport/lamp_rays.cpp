// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/lamp_rays.h"

#include "lighting/draw.h"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

namespace candelabra {

namespace {

/// Ray tolerance of a path that leaves a luminaire, as a fraction of the luminaire's radius.
constexpr double off_its_lamp = 1e-7;

std::vector<double> intensities(const WorldLights& lights) {
    std::vector<double> all;
    all.reserve(lights.luminaires.size());
    for (const Luminaire& luminaire : lights.luminaires) all.push_back(bounds(luminaire).intensity);
    return all;
}

}  // namespace

EmissionDraw emission_draw(const Key& key) {
    return {place_on_light(key),
            {uniform(key, Purpose::sent_u), uniform(key, Purpose::sent_v)},
            uniform(key, Purpose::sent_side)};
}

LampRays::LampRays(const World& world) : world_(world) {
    const std::vector<double> all = intensities(world.lights);
    places_ = WeightedPlaces(all);
    power_ = std::accumulate(all.begin(), all.end(), 0.0);
}

std::optional<LampRay> LampRays::draw(const Key& key, double choice, double share,
                                      FunctionRef<double(const Luminaire&)> inner) const {
    const LightIndex light = places_.at_share(choice);
    const Luminaire& luminaire = world_.lights.luminaires[light];
    const double chance = places_.share_of(light);
    const auto emitted = emit(luminaire, inner(luminaire), emission_draw(key));
    if (!emitted) return std::nullopt;
    LampRay drawn{light,
                  {},
                  share * dot(emitted->normal, emitted->ray.direction) /
                      (std::numbers::pi * emitted->density * chance)};
    PathState& path = drawn.path;
    path.ray = emitted->ray;
    path.tolerance = off_its_lamp * bounds(luminaire).radius;
    path.kind = RayKind::gathering;
    path.key = key;
    // Beyond the surface of the lamp, which is not inside of it.
    path.media = world_.containing(path.ray.at(path.tolerance));
    return drawn;
}

}  // namespace candelabra
