// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/direct_light.h"

#include <numbers>

namespace {

using std::numbers::pi;

Vec3 from_source(const World& world, const PointLight& light, const Shading& s, RayCounts& rays) {
    const Vec3 offset = light.location - s.position;
    const double distance = length(offset);
    if (distance == 0) return Vec3(0);
    const Vec3 direction = offset / distance;
    const Vec3 answer = response(s, direction, !light.shadowless);
    if (answer == Vec3(0)) return Vec3(0);
    Vec3 colour = light.colour * fading(light, distance);
    if (!light.shadowless) {
        ++rays.shadow;
        colour *= world.transmittance({s.position, direction}, s.tolerance, distance);
    }
    return answer * colour;
}

}  // namespace

Vec3 DirectLight::from_sources(const Shading& s, RayCounts& rays) const {
    Vec3 sum(0);
    for (const Light& light : world_.lights)
        sum += std::visit([&](const auto& l) { return from_source(world_, l, s, rays); }, light);
    return sum;
}

Vec3 DirectLight::from_luminaire(const Shading& s, const LightPick& pick, const Key& key,
                                 RayCounts& rays) const {
    const Luminaire& luminaire = world_.luminaires[pick.light];
    const auto point = sample(luminaire, s.position,
                              {uniform(key, Purpose::light_u), uniform(key, Purpose::light_v)});
    if (!point) return Vec3(0);
    const Vec3 answer = response(s, point->direction, true);
    if (answer == Vec3(0)) return Vec3(0);
    const Vec3 radiance = luminaire.varying ? world_.emission(luminaire.primitive, point->position)
                                            : luminaire.radiance;
    if (radiance == Vec3(0)) return Vec3(0);
    ++rays.shadow;
    const Vec3 passed =
        world_.transmittance({s.position, point->direction}, s.tolerance, point->distance);
    // Light from one steradian of radiance 1 is light of colour 1/pi in POV-Ray's sense.
    return answer * radiance * passed / (pi * point->density * pick.expected);
}

Vec3 DirectLight::from_luminaires(const Shading& s, const Key& key, RayCounts& rays) {
    const ShadingPoint point{s.position, s.normal, s.both_sides};
    Vec3 sum(0);
    // The conventional way asks every luminaire once; more shadow rays are more points on each.
    for (int i = 0; i < shadow_rays_; ++i) {
        Key branch = key.with_branch(static_cast<std::uint32_t>(i));
        picks_.clear();
        std::visit([&](const auto& sampler) { sampler.choose(point, branch, picks_); },
                   world_.sampler);
        const bool several = picks_.size() > 1;
        for (const LightPick& pick : picks_) {
            if (several)
                branch = key.with_branch(pick.light * static_cast<std::uint32_t>(shadow_rays_) +
                                         static_cast<std::uint32_t>(i));
            sum += from_luminaire(s, pick, branch, rays);
        }
    }
    return sum / static_cast<double>(shadow_rays_);
}

Vec3 DirectLight::operator()(const Shading& s, const Key& key, RayCounts& rays) {
    Vec3 sum(0);
    if (!answers_light(s)) return sum;
    sum = from_sources(s, rays);
    if (!world_.luminaires.empty()) sum += from_luminaires(s, key, rays);
    return sum;
}
