// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/lamp_rays.h"

#include "lighting/draw.h"
#include "world/prototype.h"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

namespace candelabra {

namespace {

/// Ray tolerance of a path that leaves a luminaire, as a fraction of the luminaire's radius.
constexpr double off_its_lamp = 1e-7;

/// Of all luminaires that belong to no instance, then of all luminaires of each instance, then of
/// the boxes of media.
std::vector<double> intensities(const WorldLights& lights) {
    std::vector<double> all;
    const LuminaireList& luminaires = lights.luminaires;
    all.reserve(luminaires.own().size() + luminaires.placed().size() + lights.media.size());
    for (const Luminaire& luminaire : luminaires.own()) all.push_back(bounds(luminaire).intensity);
    for (const PlacedLuminaires& placed : luminaires.placed()) {
        const double scale = placed.place->uniform_scale();
        const LightTree& tree = placed.prototype->lights;
        all.push_back(scale * scale * tree.intensity(tree.root()));
    }
    for (const MediaBox& box : lights.media) all.push_back(bounds(box).intensity);
    return all;
}

std::optional<EmittedRay> emitted_by(const Luminaire& luminaire,
                                     FunctionRef<double(const Luminaire&)> inner,
                                     const EmissionDraw& u) {
    return emit(luminaire, inner(luminaire), u);
}
std::optional<EmittedRay> emitted_by(const MediaBox& box, FunctionRef<double(const Luminaire&)>,
                                     const EmissionDraw& u) {
    return emit(box, u);
}

}  // namespace

EmissionDraw emission_draw(const Key& key) {
    return {place_on_light(key),
            {uniform(key, Purpose::sent_u), uniform(key, Purpose::sent_v)},
            uniform(key, Purpose::sent_side)};
}

LampRays::LampRays(const World& world) : world_(world) {
    const std::vector<double> all = intensities(world.lights);
    places_ = WeightedIndex(all);
    power_ = std::accumulate(all.begin(), all.end(), 0.0);
}

std::optional<LampRay> LampRays::draw(const Key& key, double choice, double share,
                                      FunctionRef<double(const Luminaire&)> inner) const {
    std::uint32_t light = places_.at_share(choice);
    double chance = places_.share_of(light);
    const LuminaireList& all = world_.lights.luminaires;
    const std::size_t own = all.own().size(), placed = all.placed().size();
    if (light >= own + placed) {
        light = static_cast<LightIndex>(light - own - placed + all.size());
    } else if (light >= own) {
        // The rest of the number chooses among those of the instance.
        const PlacedLuminaires& among = all.placed()[light - own];
        const LightTree& tree = among.prototype->lights;
        const std::uint32_t place = tree.draw(tree.root(), places_.within(light, choice));
        chance *= tree.share(tree.root(), place);
        light = among.first + tree.light(place);
    }
    std::optional<EmittedRay> emitted;
    double size = 0;
    world_.lights.visit(light, [&](const auto& glowing) {
        emitted = emitted_by(glowing, inner, emission_draw(key));
        size = bounds(glowing).radius;
    });
    if (!emitted) return std::nullopt;
    LampRay drawn{light,
                  {},
                  share * dot(emitted->normal, emitted->ray.direction) /
                      (std::numbers::pi * emitted->density * chance)};
    PathState& path = drawn.path;
    path.ray = emitted->ray;
    path.tolerance = off_its_lamp * size;
    path.kind = RayKind::gathering;
    path.key = key;
    // Beyond the surface of the lamp, which is not inside of it.
    path.media = world_.containing(path.ray.at(path.tolerance));
    return drawn;
}

}  // namespace candelabra
