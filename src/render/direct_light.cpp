// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/direct_light.h"

#include "render/microfacet.h"
#include "render/source_light.h"

#include <algorithm>
#include <numbers>

namespace {

using std::numbers::pi;

/// Behind all objects.
constexpr double far_away = 1e20;

/// Clear surfaces in a row that are looked through; a stop for rays that rounding keeps in one
/// place.
constexpr int most_passed = 1000;

/// At one hit, when the number is not the same for all.
constexpr int most_rays = 32;

/// Share of the shadow rays that surfaces which are all gloss scatter.
constexpr double most_by_surface = 0.5;

ShadingPoint point_of(const Shading& s) {
    return {s.position, s.normal, s.both_sides || s.finish->diffuse_back != 0};
}

/// What the surface sends on of light from there.
Vec3 answer_to(const World& world, const Shading& s, const Vec3& direction, const Key& key) {
    if (s.finish->microfacet.on) return facet_response(s, direction, Lobes::wide);
    return answer_to_light(world, s, direction, true, key);
}

Vec2 place_on_light(const Key& key) {
    return {uniform(key, Purpose::light_u), uniform(key, Purpose::light_v)};
}

}  // namespace

Vec3 DirectLight::from_sources(const Scattering& scattering, const Shading& s, const Key& key,
                               RayCounts& rays) {
    Vec3 sum(0);
    for (const SourceSet& set : world_.source_sets) {
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
    LightCount& own = rays.lights[world_.statement_of_light[light]];
    own.light.add(grey(seen));
    own.seen += rays.share * seen;
    own.rays += rays.shadow - before;
    return seen;
}

/// Notes light that came from a luminaire, and rays that were sent to it.
void DirectLight::credit_luminaire(RayCounts& rays, LightIndex light, const Vec3& seen,
                                   std::uint64_t count) const {
    if (rays.lights.empty()) return;
    LightCount& own = rays.lights[world_.statement_of_luminaire[light]];
    own.light.add(grey(seen) / rays_here_);
    own.seen += rays.share * seen / static_cast<double>(rays_here_);
    own.rays += count;
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
    for (int passed = 0; passed < most_passed; ++passed) {
        if (!world_.first_hit(ray, tolerance, RayKind::light, hit)) return {};
        const double distance = dot(hit.position - ray.origin, ray.direction);
        if (world_.material(hit.primitive).stops_light())
            return LightSight{distance, hit.normal, hit.tolerance, {}, 0};
        tolerance = distance + hit.tolerance;
    }
    return {};
}

Vec3 DirectLight::radiance(const Luminaire& luminaire, const Vec3& position) const {
    return luminaire.varying ? world_.emission(luminaire.primitive, position) : luminaire.radiance;
}

/// The density of a drawn point, per steradian, is for the caller to say.
template <class Density>
Vec3 DirectLight::from_luminaire(const Shading& s, const LightPick& pick, const Key& key,
                                 RayCounts& rays, const Density& density) const {
    const Luminaire& luminaire = world_.luminaires[pick.light];
    const auto point = sample(luminaire, point_of(s), place_on_light(key));
    if (!point) return Vec3(0);
    const Vec3 answer = answer_to(world_, s, point->direction, key);
    if (answer == Vec3(0)) return Vec3(0);
    const Vec3 sent = radiance(luminaire, point->position);
    if (sent == Vec3(0)) return Vec3(0);
    ++rays.shadow;
    const Vec3 passed = world_.transmittance({s.position, point->direction}, s.tolerance,
                                             point->distance, s.around);
    // Light from one steradian of radiance 1 is light of colour 1/pi in POV-Ray's sense.
    const Vec3 seen = passed == Vec3(0) ? passed : answer * sent * passed / (pi * density(*point));
    credit_luminaire(rays, pick.light, seen, 1);
    return seen;
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
        sum +=
            from_luminaire(s, pick, several ? key.with_branch(pick.light) : key, rays,
                           [&](const LightPoint& point) { return point.density * pick.expected; });
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
        const Vec3 passed = world_.transmittance(ray, s.tolerance, met.meeting.distance, s.around);
        if (passed == Vec3(0)) break;
        const Luminaire& luminaire = world_.luminaires[met.light];
        const Vec3 seen = weight(met) * passed * radiance(luminaire, ray.at(met.meeting.distance));
        credit_luminaire(rays, met.light, seen, 1);
        sum += seen;
        if (world_.material(luminaire.primitive).stops_light()) break;
    }
    return sum;
}

/// A direction from the cell's outlook, or as a glossy surface scatters light, in which whatever
/// luminaire is seen counts, or a luminaire and a point on it: weighed by the density that all ways
/// together have for a point of a luminaire (one-sample multiple importance sampling). So a
/// luminaire that the outlook does not know keeps its chance, no ray is lost where luminaires hide
/// each other, and none glares that only a highlight shows.
Vec3 DirectLight::from_cell(const Octree& octree, const Octree::Weights& weights,
                            const Scattering& scattering, const Shading& s, const Key& key,
                            RayCounts& rays) {
    const ShadingPoint point = point_of(s);
    const double by_surface =
        weights.as_scattered ? 1 : most_by_surface * std::sqrt(scattering.gloss());
    const double by_outlook = (1 - by_surface) * weights.by_direction;
    const double by_direction = by_surface + by_outlook, by_choice = 1 - by_direction;
    const auto density = [&](const Vec3& direction) {
        return (by_surface > 0 ? by_surface * scattering.density(direction) : 0) +
               (by_outlook > 0 ? by_outlook * Outlook::density(weights.outlook, direction) : 0);
    };
    const double u = uniform(key, Purpose::light_choice);
    if (u < by_direction) {
        const auto direction =
            u < by_surface
                ? scattering.draw(place_on_light(key))
                : std::optional(Outlook::draw(weights.outlook, place_on_light(key)).direction);
        const Vec3 answer = direction ? answer_to(world_, s, *direction, key) : Vec3(0);
        if (answer == Vec3(0)) return Vec3(0);
        const double of_direction = density(*direction);
        return seen_towards(s, *direction, rays, [&](const Met& met) {
            const double of_point =
                by_choice > 0 ? octree.expected(point, weights, met.light) * met.meeting.density
                              : 0;
            return answer / pi / (of_direction + by_choice * of_point);
        });
    }
    picks_.clear();
    octree.choose(point, weights, key, (u - by_direction) / by_choice, picks_);
    if (picks_.empty()) return Vec3(0);
    const LightPick& pick = picks_.front();
    return from_luminaire(s, pick, key, rays, [&](const LightPoint& p) {
        return density(p.direction) + by_choice * pick.expected * p.density;
    });
}

/// What a ray that is tried meets first.
std::optional<LightSight> DirectLight::sight(const Ray& ray, double tolerance) const {
    Hit hit;
    if (!world_.first_hit(ray, tolerance, RayKind::light, hit)) return {};
    LightSight result{
        dot(hit.position - ray.origin, ray.direction), hit.normal, hit.tolerance, {}, 0};
    const LightIndex light = world_.luminaire_of[hit.primitive];
    if (light != no_primitive) {
        result.light = light;
        result.luminance = luminance(radiance(world_.luminaires[light], hit.position));
    }
    result.passes = luminance(world_.passed(hit, ray));
    return result;
}

/// The radiance of all luminaires that are seen in a direction, each times its weight.
template <class Weight>
Vec3 DirectLight::seen_towards(const Shading& s, const Vec3& direction, RayCounts& rays,
                               const Weight& weight) {
    ++rays.shadow;
    const ShadingPoint point = point_of(s);
    const Ray ray{s.position, direction};
    double from = s.tolerance;
    bool first = true;  // no luminaire was met yet
    Vec3 sum(0);
    for (int passed = 0; passed < most_passed; ++passed) {
        Hit hit;
        if (!world_.first_hit(ray, from, RayKind::light, hit)) break;
        const double distance = dot(hit.position - s.position, direction);
        const LightIndex light = world_.luminaire_of[hit.primitive];
        if (light != no_primitive) {
            const Vec3 clear =
                passed == 0 ? Vec3(1) : world_.transmittance(ray, s.tolerance, distance, s.around);
            if (clear == Vec3(0)) break;
            meetings_.clear();
            meet(world_.luminaires[light], point, direction, meetings_);
            Vec3 seen(0);
            for (const LightMeeting& meeting : meetings_)
                if (std::abs(meeting.distance - distance) <= 1e-6 * distance + hit.tolerance)
                    seen += clear * weight(Met{meeting, light}) *
                            radiance(world_.luminaires[light], hit.position);
            credit_luminaire(rays, light, seen, first ? 1 : 0);
            first = false;
            sum += seen;
        }
        if (world_.material(hit.primitive).stops_light()) break;
        from = distance + hit.tolerance;
    }
    if (first && !rays.lights.empty()) ++rays.lights.back().rays;
    return sum;
}

Vec3 DirectLight::from_cuts(const Octree& octree, const Scattering& scattering, const Shading& s,
                            const Key& key, RayCounts& rays) {
    Octree::Weights weights;
    const ShadingPoint point = point_of(s);
    octree.weigh(
        point, [&](const Ray& ray, double tolerance) { return sight(ray, tolerance); },
        scattering.answers(), weights);
    rays_here_ = rays_at(weights, scattering, s, key, rays);
    Vec3 sum(0);
    for (int i = 0; i < rays_here_; ++i)
        sum += from_cell(octree, weights, scattering, s, key.part(rays_here_, i), rays);
    return sum;
}

/// As many as the noise that is expected here asks for; powers of two, as Sobol points like it.
int DirectLight::rays_at(const Octree::Weights& weights, const Scattering& scattering,
                         const Shading& s, const Key& key, const RayCounts& rays) {
    if (weights.noise < 0) return shadow_rays_.usual;
    const Vec3 straight = answer_to(world_, s, s.normal, key) + Vec3(scattering.highlights());
    const double noise = weights.noise * std::abs(grey(rays.share * straight));
    noise_.sum += noise;
    noise_.squares += noise * noise;
    ++noise_.hits;
    if (shadow_rays_.usual_noise == 0) return shadow_rays_.usual;
    const double wanted = shadow_rays_.usual * noise / shadow_rays_.usual_noise;
    const double exponent = std::round(std::log2(std::clamp<double>(wanted, 1, most_rays)));
    return 1 << static_cast<int>(exponent);
}

/// What other renderers do: a point on a luminaire and a direction of the surface, weighed by the
/// balance heuristic (Veach).
Vec3 DirectLight::from_pair(const BuiltLightBvh& bvh, const Scattering& scattering,
                            const Shading& s, const Key& key, RayCounts& rays) {
    Vec3 sum = from_surface(bvh, scattering, s, key.with_branch(1), rays);
    picks_.clear();
    bvh.choose(point_of(s), key, picks_);
    if (picks_.empty()) return sum;
    const LightPick pick = picks_.front();
    return sum + from_luminaire(s, pick, key, rays, [&](const LightPoint& point) {
               return point.density * pick.expected + scattering.density(point.direction);
           });
}

Vec3 DirectLight::from_surface(const BuiltLightBvh& bvh, const Scattering& scattering,
                               const Shading& s, const Key& key, RayCounts& rays) {
    const auto direction = scattering.draw(place_on_light(key));
    const Vec3 answer = direction ? answer_to(world_, s, *direction, key) : Vec3(0);
    if (answer == Vec3(0)) return Vec3(0);
    const double own = scattering.density(*direction);
    meet_along(bvh.tree(), s, *direction);
    const Vec3 seen = seen_along(s, *direction, rays, [&](const Met& met) {
        const double other = bvh.expected(point_of(s), key, met.light) * met.meeting.density;
        return answer / (pi * (own + other));
    });
    return seen;
}

Vec3 DirectLight::from_luminaires(const Scattering& scattering, const Shading& s, const Key& key,
                                  RayCounts& rays) {
    const auto repeated = [&](const auto& once) {
        Vec3 sum(0);
        for (int i = 0; i < rays_here_; ++i) sum += once(key.part(rays_here_, i));
        return sum;
    };
    const auto ask = [&](const auto& sampler) {
        using Sampler = std::decay_t<decltype(sampler)>;
        if constexpr (std::is_same_v<Sampler, BuiltLightOctree>)
            if (const Octree* octree = sampler.cuts())
                return from_cuts(*octree, scattering, s, key, rays);
        if constexpr (std::is_same_v<Sampler, BuiltLightBvh>)
            if (sampler.paired())
                return repeated(
                    [&](const Key& k) { return from_pair(sampler, scattering, s, k, rays); });
        return repeated([&](const Key& k) { return from_picks(sampler, s, k, rays); });
    };
    rays_here_ = shadow_rays_.usual;
    const Vec3 sum = std::visit(ask, world_.sampler);
    return sum / static_cast<double>(rays_here_);
}

/// A direction from where the sky is bright or the surface answers, weighed by the density that
/// both ways together have.
Vec3 DirectLight::from_sky(const Scattering& scattering, const Shading& s, const Key& key,
                           RayCounts& rays) const {
    const SkyLight& sky = world_.sky_light;
    const double u = uniform(key, Purpose::sky_choice);
    const Vec2 place{uniform(key, Purpose::sky_u), uniform(key, Purpose::sky_v)};
    const auto direction =
        u < 0.5 ? std::optional(sky.draw(place).direction) : scattering.draw(place);
    const Vec3 answer = direction ? answer_to(world_, s, *direction, key) : Vec3(0);
    if (answer == Vec3(0)) return Vec3(0);
    ++rays.shadow;
    const Vec3 passed =
        world_.transmittance({s.position, *direction}, s.tolerance, far_away, s.around);
    if (passed == Vec3(0)) return Vec3(0);
    const double density = 0.5 * (sky.density(*direction) + scattering.density(*direction));
    return answer * passed * world_.sky_radiance(*direction) / (pi * density);
}

Vec3 DirectLight::operator()(const Shading& s, const Key& key, RayCounts& rays) {
    Vec3 sum(0);
    if (!answers_light(s)) return sum;
    const Scattering scattering(s);
    sum = from_sources(scattering, s, key, rays);
    if (!world_.luminaires.empty()) sum += from_luminaires(scattering, s, key, rays);
    if (world_.sky_light.empty()) return sum;
    Vec3 of_sky(0);
    const int count = shadow_rays_.usual;
    for (int i = 0; i < count; ++i) of_sky += from_sky(scattering, s, key.part(count, i), rays);
    return sum + of_sky / static_cast<double>(count);
}
