// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/direct_light.h"

#include "base/gamma.h"
#include "render/microfacet.h"
#include "render/source_light.h"

#include <algorithm>
#include <numbers>

namespace {

using std::numbers::pi;

/// Behind all objects.
constexpr double far_away = 1e20;

/// At one hit, when the number is not the same for all.
constexpr int most_rays = 32;

/// Standard deviation that luminaires may add to a sample where other light is, in steps of a
/// picture of 8 bits.
constexpr double hidden_steps = 4;
/// That they are asked all the same.
constexpr double least_chance = 1.0 / 256;

/// Share of the shadow rays that surfaces which are all gloss scatter.
constexpr double most_by_surface = 0.5;

/// What the surface sends on of light from there.
Vec3 answer_to(const World& world, const Shading& s, const Vec3& direction, const Key& key) {
    if (s.finish->microfacet.on) return facet_response(s, direction, Lobes::wide);
    return answer_to_light(world, s, direction, true, key);
}

/// A difference of radiance that is so many steps of what is displayed.
double visible_step(double radiance) {
    constexpr double gamma = display_gamma, steps = 255;
    return hidden_steps / steps * gamma * std::pow(std::fmin(radiance, 1), 1 - 1 / gamma);
}

Vec2 place_on_light(const Key& key) {
    return {uniform(key, Purpose::light_u), uniform(key, Purpose::light_v)};
}

}  // namespace

ShadingPoint point_of(const Shading& s) {
    return {s.position, s.normal, s.both_sides || s.finish->diffuse_back != 0};
}

/// Notes light that came from a luminaire, and rays that were sent to it.
void DirectLight::credit_luminaire(RayCounts& rays, LightIndex light, const Vec3& seen,
                                   std::uint64_t count) const {
    if (rays.lights.empty()) return;
    LightCount& own = rays.lights[world_.provenance.statement_of_luminaire[light]];
    own.light.add(grey(seen) / asked_here_);
    own.seen += rays.share * seen / asked_here_;
    own.rays += count;
}

Vec3 DirectLight::radiance(const Luminaire& luminaire, const Vec3& position) const {
    return luminaire.varying ? world_.emission(luminaire.primitive, position) : luminaire.radiance;
}

template <class Density>
Vec3 DirectLight::from_luminaire(const Shading& s, const LightPick& pick, const Key& key,
                                 RayCounts& rays, const Density& density) {
    const Luminaire& luminaire = world_.lights.luminaires[pick.light];
    if (const auto searched = SearchedLuminaire::of(luminaire)) {
        const auto drawn = searched->draw(s.position, place_on_light(key));
        const Vec3 answer = drawn ? answer_to(world_, s, drawn->direction, key) : Vec3(0);
        if (answer == Vec3(0)) return Vec3(0);
        const Vec3 weight = answer / (pi * density(drawn->direction, drawn->density));
        return seen_towards(s, drawn->direction, rays, [&](LightIndex light, double) {
            return light == pick.light ? weight : Vec3(0);
        });
    }
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
    const Vec3 seen = passed == Vec3(0) ? passed
                                        : answer * sent * passed /
                                              (pi * density(point->direction, point->density));
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
                           [&](const Vec3&, double of_point) { return of_point * pick.expected; });
    return sum;
}

/// Fills met_ with all luminaires on the line.
void DirectLight::meet_along(const LightTree& tree, const Shading& s, const Vec3& direction) {
    met_.clear();
    const ShadingPoint point = point_of(s);
    tree.along(s.position, direction, [&](LightIndex light) {
        meetings_.clear();
        meet(world_.lights.luminaires[light], point, direction, meetings_);
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
        const Luminaire& luminaire = world_.lights.luminaires[met.light];
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
        return seen_towards(s, *direction, rays, [&](LightIndex light, double density_there) {
            const double of_point =
                by_choice > 0 ? octree.expected(point, weights, light) * density_there : 0;
            return answer / pi / (of_direction + by_choice * of_point);
        });
    }
    picks_.clear();
    octree.choose(point, weights, key, (u - by_direction) / by_choice, picks_);
    if (picks_.empty()) return Vec3(0);
    const LightPick& pick = picks_.front();
    return from_luminaire(s, pick, key, rays, [&](const Vec3& direction, double of_point) {
        return density(direction) + by_choice * pick.expected * of_point;
    });
}

/// What a ray that is tried meets first.
std::optional<LightSight> DirectLight::sight(const Ray& ray, double tolerance) const {
    Hit hit;
    if (!world_.first_hit(ray, tolerance, RayKind::light, hit)) return {};
    LightSight result{
        dot(hit.position - ray.origin, ray.direction), hit.normal, hit.tolerance, {}, 0};
    const LightIndex light = world_.lights.luminaire_of[hit.primitive];
    if (light != no_primitive) {
        result.light = light;
        result.luminance = luminance(radiance(world_.lights.luminaires[light], hit.position));
    }
    result.passes = luminance(world_.passed(hit, ray));
    return result;
}

/// The radiance of all luminaires that are seen in a direction, each times its weight.
template <class Weight>
Vec3 DirectLight::seen_towards(const Shading& s, const Vec3& direction, RayCounts& rays,
                               const Weight& weight) {
    ++rays.shadow;
    const Ray ray{s.position, direction};
    double from = s.tolerance;
    Vec3 sum(0);
    met_.clear();
    for (int passed = 0; passed < max_clear_surfaces; ++passed) {
        Hit hit;
        if (!world_.first_hit(ray, from, RayKind::light, hit)) break;
        const double distance = dot(hit.position - s.position, direction);
        const LightIndex light = world_.lights.luminaire_of[hit.primitive];
        if (light != no_primitive) {
            const Vec3 clear =
                passed == 0 ? Vec3(1) : world_.transmittance(ray, s.tolerance, distance, s.around);
            if (clear == Vec3(0)) break;
            Vec3 weights(0);
            for_densities(light, s, direction, {distance, hit.tolerance},
                          [&](double density) { weights += weight(light, density); });
            const Vec3 seen =
                weights == Vec3(0)
                    ? weights
                    : clear * weights * radiance(world_.lights.luminaires[light], hit.position);
            credit_luminaire(rays, light, seen, met_.empty() ? 1 : 0);
            met_.push_back({{distance, 0}, light});
            sum += seen;
        }
        if (world_.material(hit.primitive).stops_light()) break;
        from = distance + hit.tolerance;
    }
    if (met_.empty() && !rays.lights.empty()) ++rays.lights.back().rays;
    return sum;
}

/// Calls visit with the density of each drawn point of the luminaire that is met there, if it may
/// be drawn. Of luminaires that are searched that is the first one on the way, which met_ knows.
template <class Visit>
void DirectLight::for_densities(LightIndex light, const Shading& s, const Vec3& direction,
                                const Distance& there, const Visit& visit) {
    const Luminaire& luminaire = world_.lights.luminaires[light];
    if (const auto searched = SearchedLuminaire::of(luminaire)) {
        if (std::ranges::find(met_, light, &Met::light) == met_.end())
            visit(searched->density(s.position, direction));
        return;
    }
    meetings_.clear();
    meet(luminaire, point_of(s), direction, meetings_);
    for (const LightMeeting& meeting : meetings_)
        if (std::abs(meeting.distance - there.distance) <= 1e-6 * there.distance + there.tolerance)
            visit(meeting.density);
}

Vec3 DirectLight::from_cuts(const Octree& octree, const Scattering& scattering, const Shading& s,
                            const Key& key, const Vec3& before, RayCounts& rays) {
    Octree::Weights weights;
    const ShadingPoint point = point_of(s);
    octree.weigh(
        point, [&](const Ray& ray, double tolerance) { return sight(ray, tolerance); },
        scattering.answers(), weights);
    const Vec3 straight = answer_to(world_, s, s.normal, key) + Vec3(scattering.highlights());
    const double chance = chance_of_asking(weights, straight, before, rays);
    if (chance < 1 && uniform(key, Purpose::light_roulette) >= chance) return Vec3(0);
    rays_here_ = rays_at(weights, straight, rays);
    asked_here_ = rays_here_ * chance;
    Vec3 sum(0);
    for (int i = 0; i < rays_here_; ++i)
        sum += from_cell(octree, weights, scattering, s, key.part(rays_here_, i), rays);
    return sum / chance;
}

/// Of luminaires whose light, by the estimate of the cell, is small against what is there already:
/// some hits ask them, for all (Russian roulette). The noise of that is too small to be seen.
double DirectLight::chance_of_asking(const Octree::Weights& weights, const Vec3& straight,
                                     const Vec3& before, const RayCounts& rays) const {
    const double share = std::abs(grey(rays.share)), there = share * grey(before);
    if (!(there > 0) || weights.noise < 0) return 1;
    const double answer = share * std::abs(grey(straight)) / pi;
    const double mean = answer * weights.irradiance, deviation = answer * weights.noise;
    const double squares = mean * mean + deviation * deviation;
    const double visible = visible_step(there);
    return std::clamp(squares / (mean * mean + visible * visible), least_chance, 1.0);
}

/// As many as the noise that is expected here asks for; powers of two, as Sobol points like it.
int DirectLight::rays_at(const Octree::Weights& weights, const Vec3& straight,
                         const RayCounts& rays) {
    if (weights.noise < 0) return shadow_rays_.usual;
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
    return sum + from_luminaire(s, pick, key, rays, [&](const Vec3& direction, double of_point) {
               return of_point * pick.expected + scattering.density(direction);
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
                                  const Vec3& before, RayCounts& rays) {
    const auto repeated = [&](const auto& once) {
        Vec3 sum(0);
        for (int i = 0; i < rays_here_; ++i) sum += once(key.part(rays_here_, i));
        return sum;
    };
    const auto ask = [&](const auto& sampler) {
        using Sampler = std::decay_t<decltype(sampler)>;
        if constexpr (std::is_same_v<Sampler, BuiltLightOctree>)
            if (const Octree* octree = sampler.cuts())
                return from_cuts(*octree, scattering, s, key, before, rays);
        if constexpr (std::is_same_v<Sampler, BuiltLightBvh>)
            if (sampler.paired())
                return repeated(
                    [&](const Key& k) { return from_pair(sampler, scattering, s, k, rays); });
        return repeated([&](const Key& k) { return from_picks(sampler, s, k, rays); });
    };
    rays_here_ = shadow_rays_.usual;
    asked_here_ = rays_here_;
    const Vec3 sum = std::visit(ask, world_.lights.sampler);
    return sum / static_cast<double>(rays_here_);
}

/// A direction from where the sky is bright or the surface answers, weighed by the density that
/// both ways together have.
Vec3 DirectLight::from_sky(const Scattering& scattering, const Shading& s, const Key& key,
                           RayCounts& rays) const {
    const SkyLight& sky = world_.sky.light;
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
    if (!world_.lights.luminaires.empty()) sum += from_luminaires(scattering, s, key, sum, rays);
    if (world_.sky.light.empty()) return sum;
    Vec3 of_sky(0);
    const int count = shadow_rays_.usual;
    for (int i = 0; i < count; ++i) of_sky += from_sky(scattering, s, key.part(count, i), rays);
    return sum + of_sky / static_cast<double>(count);
}
