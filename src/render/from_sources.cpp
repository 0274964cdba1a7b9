// SPDX-License-Identifier: GPL-3.0-or-later
// Direct light of POV-Ray's light sources: each of them is asked, or some of many.
#include "render/direct_light.h"
#include "render/source_light.h"

Vec3 DirectLight::from_sources(const Scattering& scattering, const Shading& s, const Key& key,
                               RayCounts& rays) {
    Vec3 sum(0);
    for (const SourceSet& set : world_.lights.source_sets) {
        if (!world_.reaches(set.group, *s.material)) continue;
        if (set.drawn())
            sum += from_drawn_sources(set, scattering, s, key, rays);
        else
            for (const std::uint32_t light : set.lights) sum += from_source(light, 1, s, key, rays);
    }
    return sum;
}

Vec3 DirectLight::from_source(std::uint32_t light, double weight, const Shading& s, const Key& key,
                              RayCounts& rays) {
    const std::uint64_t before = rays.shadow;
    const Vec3 seen = weight * source_light(world_, light, s, key, rays);
    if (rays.lights.empty()) return seen;
    LightCount& own = rays.lights[world_.provenance.statement_of_light[light]];
    own.light.add(grey(seen));
    own.seen += rays.share * seen;
    own.rays += rays.shadow - before;
    return seen;
}

/// Some of many.
Vec3 DirectLight::from_drawn_sources(const SourceSet& set, const Scattering& scattering,
                                     const Shading& s, const Key& key, RayCounts& rays) {
    const Key own = Key{key.pixel, key.sample, key.path * 31u + 5u, 0};
    const ShadingPoint point = set.asked(point_of(s));
    const BuiltLightOctree* octree = std::get_if<BuiltLightOctree>(&set.sampler);
    const Octree* cuts = octree ? octree->cuts() : nullptr;
    Octree::Weights weights;
    const auto past_clear = [&](const Ray& ray, double tolerance) {
        return sight_past_clear(ray, tolerance);
    };
    if (cuts && !set.parallel) cuts->weigh(point, past_clear, scattering.answers(), weights);
    if (cuts && set.parallel) cuts->weigh_choice(point, scattering.answers(), weights);
    Vec3 sum(0);
    for (int i = 0; i < shadow_rays_.usual; ++i) {
        const Key part = own.part(shadow_rays_.usual, i);
        picks_.clear();
        if (cuts)
            cuts->choose(point, weights, part, uniform(part, Purpose::light_choice), picks_);
        else
            std::visit([&](const auto& b) { b.choose(point, part, picks_); }, set.sampler);
        for (const LightPick& pick : picks_)
            sum += from_source(set.lights[pick.light], 1 / (pick.expected * shadow_rays_.usual), s,
                               part, rays);
    }
    return sum;
}

/// The first thing on a ray that stops all light.
std::optional<LightSight> DirectLight::sight_past_clear(const Ray& ray, double tolerance) const {
    Hit hit;
    for (int passed = 0; passed < max_clear_surfaces; ++passed) {
        if (!world_.first_hit(ray, tolerance, RayKind::light, hit)) return {};
        const double distance = dot(hit.position - ray.origin, ray.direction);
        if (world_.material(hit.primitive).stops_light())
            return LightSight{distance, hit.normal, hit.tolerance, {}, 0};
        tolerance = distance + hit.tolerance;
    }
    return {};
}
