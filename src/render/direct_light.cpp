// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/direct_light.h"

#include <algorithm>
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

/// From so many luminaires on a line, or such a share of the sky, whole lines are asked.
constexpr double crowded = 1.3, covered = 0.05;

ShadingPoint point_of(const Shading& s) { return {s.position, s.normal, s.both_sides}; }

Vec2 place_on_light(const Key& key) {
    return {uniform(key, Purpose::light_u), uniform(key, Purpose::light_v)};
}

/// A direction as a diffuse surface scatters it, in proportion to the cosine; u is in [0, 1)^2.
Vec3 scattered(const Shading& s, Vec2 u) {
    Vec3 normal = s.normal;
    if (s.both_sides) {
        if (u.x >= 0.5) normal = -normal;
        u.x = u.x < 0.5 ? 2 * u.x : 2 * u.x - 1;
    }
    const auto [x, y] = perpendiculars(normal);
    const double across = std::sqrt(u.x), angle = 2 * pi * u.y;
    return across * (std::cos(angle) * x + std::sin(angle) * y) + std::sqrt(1 - u.x) * normal;
}

/// Probability per steradian of that direction.
double scattered_density(const Shading& s, const Vec3& direction) {
    const double cosine = dot(s.normal, direction);
    return s.both_sides ? std::abs(cosine) / (2 * pi) : std::fmax(cosine, 0) / pi;
}

/// The share of the shadow rays that the surface chooses: the more of its sky the luminaires fill
/// (coverage, which is above 1 where they hide each other), the better it does.
double surface_share(double greatest, double coverage) {
    return greatest * (coverage / (1 + coverage));
}

}  // namespace

Vec3 DirectLight::from_sources(const Shading& s, RayCounts& rays) const {
    Vec3 sum(0);
    for (const Light& light : world_.lights)
        sum += std::visit([&](const auto& l) { return from_source(world_, l, s, rays); }, light);
    return sum;
}

Vec3 DirectLight::radiance(const Luminaire& luminaire, const Vec3& position) const {
    return luminaire.varying ? world_.emission(luminaire.primitive, position) : luminaire.radiance;
}

Vec3 DirectLight::from_luminaire(const Shading& s, const LightPick& pick, const Key& key,
                                 RayCounts& rays) const {
    const Luminaire& luminaire = world_.luminaires[pick.light];
    const auto point = sample(luminaire, point_of(s), place_on_light(key));
    if (!point) return Vec3(0);
    const Vec3 answer = response(s, point->direction, true);
    if (answer == Vec3(0)) return Vec3(0);
    const Vec3 sent = radiance(luminaire, point->position);
    if (sent == Vec3(0)) return Vec3(0);
    ++rays.shadow;
    const Vec3 passed =
        world_.transmittance({s.position, point->direction}, s.tolerance, point->distance);
    // Light from one steradian of radiance 1 is light of colour 1/pi in POV-Ray's sense.
    return answer * sent * passed / (pi * point->density * pick.expected);
}

template <class Sampler>
Vec3 DirectLight::from_picks(const Sampler& sampler, const Shading& s, const Key& key,
                             RayCounts& rays) {
    picks_.clear();
    sampler.choose(point_of(s), key, picks_);
    Vec3 sum(0);
    // The conventional way asks every luminaire once; more shadow rays are more points on each.
    const bool several = picks_.size() > 1;
    for (const LightPick& pick : picks_)
        sum += from_luminaire(s, pick, several ? key.with_branch(pick.light) : key, rays);
    return sum;
}

/// Fills met_ with all luminaires on the line.
void DirectLight::meet_along(const LightTree& tree, const Shading& s, const Vec3& direction) {
    met_.clear();
    const ShadingPoint point = point_of(s);
    tree.along(s.position, direction, [&](LightIndex light) {
        meetings_.clear();
        meet(world_.luminaires[light], point, direction, meetings_);
        for (const LightMeeting& meeting : meetings_)
            // The point may lie on a luminaire, which does not light itself there.
            if (meeting.distance > s.tolerance) met_.push_back({meeting, light});
    });
    std::ranges::sort(met_, [](const Met& a, const Met& b) {
        return std::pair(a.meeting.distance, a.light) < std::pair(b.meeting.distance, b.light);
    });
}

/// The radiance of those of met_ that are seen, each times its weight.
template <class Weight>
Vec3 DirectLight::seen_along(const Shading& s, const Vec3& direction, RayCounts& rays,
                             const Weight& weight) const {
    Vec3 sum(0);
    const Ray ray{s.position, direction};
    for (const Met& met : met_) {
        ++rays.shadow;
        const Vec3 passed = world_.transmittance(ray, s.tolerance, met.meeting.distance);
        if (passed == Vec3(0)) break;
        const Luminaire& luminaire = world_.luminaires[met.light];
        sum += weight(met) * passed * radiance(luminaire, ray.at(met.meeting.distance));
        const Material& material = world_.material(luminaire.primitive);
        if (!material.transparent && !material.no_shadow) break;
    }
    return sum;
}

/// A direction chosen by a luminaire or by the surface; whatever luminaire it meets counts, by the
/// density that all together have for it. So no ray is wasted that another luminaire stops, and the
/// estimate is never far above what is there.
Vec3 DirectLight::from_line(const Octree& octree, const Octree::Weights& weights, const Shading& s,
                            const Key& key, RayCounts& rays) {
    const ShadingPoint point = point_of(s);
    const double by_surface =
        weights.even ? 0 : surface_share(octree.settings().brdf, weights.coverage);
    const double u = uniform(key, Purpose::light_choice);
    Vec3 direction;
    if (u < by_surface) {
        direction = scattered(s, place_on_light(key));
    } else {
        picks_.clear();
        octree.choose(point, weights, key, (u - by_surface) / (1 - by_surface), picks_);
        if (picks_.empty()) return Vec3(0);
        const auto drawn =
            sample(world_.luminaires[picks_.front().light], point, place_on_light(key));
        if (!drawn) return Vec3(0);
        direction = drawn->direction;
    }
    const Vec3 answer = response(s, direction, true);
    if (answer == Vec3(0)) return Vec3(0);
    meet_along(octree.tree(), s, direction);
    const Vec3 seen = seen_along(s, direction, rays, [](const Met&) { return 1.0; });
    if (seen == Vec3(0)) return Vec3(0);
    double density = 0;
    for (const Met& met : met_)
        density += octree.expected(point, weights, met.light) * met.meeting.density;
    density = (1 - by_surface) * density + by_surface * scattered_density(s, direction);
    return density > 0 ? answer * seen / (pi * density) : Vec3(0);
}

Vec3 DirectLight::from_cuts(const Octree& octree, const Shading& s, const Key& key,
                            RayCounts& rays) {
    Octree::Weights weights;
    const ShadingPoint point = point_of(s);
    octree.weigh(point, weights);
    // Where luminaires stand apart and fill little of the sky, no other one is likely to be met.
    const bool lines = !octree.settings().alone && (weights.crowding > crowded ||
                                                    (!weights.even && weights.coverage > covered));
    Vec3 sum(0);
    for (int i = 0; i < shadow_rays_; ++i) {
        const Key part = key.part(shadow_rays_, i);
        if (lines) {
            sum += from_line(octree, weights, s, part, rays);
            continue;
        }
        picks_.clear();
        octree.choose(point, weights, part, uniform(part, Purpose::light_choice), picks_);
        for (const LightPick& pick : picks_) sum += from_luminaire(s, pick, part, rays);
    }
    return sum;
}

/// What other renderers do: a point on a luminaire and a direction of the surface, weighed by the
/// balance heuristic (Veach).
Vec3 DirectLight::from_pair(const BuiltLightBvh& bvh, const Shading& s, const Key& key,
                            RayCounts& rays) {
    Vec3 sum = from_surface(bvh, s, key.with_branch(1), rays);
    picks_.clear();
    bvh.choose(point_of(s), key, picks_);
    if (picks_.empty()) return sum;
    const LightPick pick = picks_.front();
    const auto drawn = sample(world_.luminaires[pick.light], point_of(s), place_on_light(key));
    if (!drawn) return sum;
    const double own = pick.expected * drawn->density;
    const double weight = own / (own + scattered_density(s, drawn->direction));
    return sum + weight * from_luminaire(s, pick, key, rays);
}

Vec3 DirectLight::from_surface(const BuiltLightBvh& bvh, const Shading& s, const Key& key,
                               RayCounts& rays) {
    const Vec3 direction = scattered(s, place_on_light(key));
    const Vec3 answer = response(s, direction, true);
    const double own = scattered_density(s, direction);
    if (answer == Vec3(0) || !(own > 0)) return Vec3(0);
    meet_along(bvh.tree(), s, direction);
    const Vec3 seen = seen_along(s, direction, rays, [&](const Met& met) {
        const double other = bvh.expected(point_of(s), key, met.light) * met.meeting.density;
        return own / (own + other);
    });
    return answer * seen / (pi * own);
}

Vec3 DirectLight::from_luminaires(const Shading& s, const Key& key, RayCounts& rays) {
    const auto repeated = [&](const auto& once) {
        Vec3 sum(0);
        for (int i = 0; i < shadow_rays_; ++i) sum += once(key.part(shadow_rays_, i));
        return sum;
    };
    const auto ask = [&](const auto& sampler) {
        using Sampler = std::decay_t<decltype(sampler)>;
        if constexpr (std::is_same_v<Sampler, BuiltLightOctree>)
            if (const Octree* octree = sampler.cuts()) return from_cuts(*octree, s, key, rays);
        if constexpr (std::is_same_v<Sampler, BuiltLightBvh>)
            if (sampler.paired())
                return repeated([&](const Key& k) { return from_pair(sampler, s, k, rays); });
        return repeated([&](const Key& k) { return from_picks(sampler, s, k, rays); });
    };
    return std::visit(ask, world_.sampler) / static_cast<double>(shadow_rays_);
}

Vec3 DirectLight::operator()(const Shading& s, const Key& key, RayCounts& rays) {
    Vec3 sum(0);
    if (!answers_light(s)) return sum;
    sum = from_sources(s, rays);
    if (!world_.luminaires.empty()) sum += from_luminaires(s, key, rays);
    return sum;
}
