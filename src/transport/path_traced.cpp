// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/path_traced.h"

#include "scattering/microfacet.h"
#include "scattering/mirror.h"
#include "scattering/phong.h"
#include "surface/quality.h"
#include "transport/atmosphere.h"
#include "transport/path_steps.h"
#include "transport/subsurface.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace candelabra {

namespace {

/// Number of diffuse bounces from which on paths are subject to Russian roulette by throughput.
constexpr int first_roulette = 2;
/// Survival probability of a path for which reflected luminaires account for all light except that
/// of highlights and mirrors.
constexpr double chance_of_shine = 0.25;
/// Minimum survival probability in Russian roulette.
constexpr double min_survival = 0.05;

/// Approximate fraction of uniform incident light that the diffuse part reflects to the viewer.
Vec3 diffuse_albedo(const Shading& s, const std::optional<Microfacets>& facets) {
    const Finish& f = *s.finish;
    const double amount =
        facets ? facets->base_albedo() : std::fmax(f.diffuse, 0) + std::abs(f.diffuse_back);
    return s.colour.rgb * (s.opacity * amount);
}

/// Whether a layer reflects and transmits no more than all light, as its finish says.
[[maybe_unused]] bool adds_no_light(const Layer& layer) {
    const Finish& f = *layer.finish;
    const bool mirrors = f.reflection.least != Vec3(0) || f.reflection.greatest != Vec3(0);
    const bool scatters = !f.microfacet.on && f.diffuse + f.diffuse_back > 1;
    return !scatters && (f.conserve_energy || !mirrors) && f.refraction <= 1 && f.brilliance >= 1 &&
           min_component(layer.colour.rgb) >= 0 && max_component(layer.colour.rgb) <= 1 &&
           layer.colour.opacity() >= 0;
}

}  // namespace

PathTracedIntegrator::PathTracedIntegrator(const World& world, const Tracing& wanted)
    : world_(world),
      rules_(shading_rules(world)),
      direct_light_(world, wanted.shadow_rays, wanted.sent->photons),
      reflected_(world, wanted.sent->reflected),
      media_(world),
      ends_(world, wanted.clear_sky),
      ledger_(empty_ledger(world, wanted.counts_lights)),
      max_bounces_(std::get<PathTraced>(world.rules.settings.integrator).bounces),
      chance_of_covered_(world.is_lit_by_luminaires_only() ? chance_of_shine : 1) {}

Vec3 PathTracedIntegrator::radiance(const Ray& ray, const Key& key) {
    sum_ = Vec3(0);
    const PathState path = ends_.begin(ray, key);
    direct_light_.begin(key.sample);
    reflected_.begin(key.sample);
    if (ray.direction == Vec3(0)) return sum_;
    ++ledger_.camera;
    divided_ = false;
    trace(path);
    if (const auto scattered = std::exchange(aside_, std::nullopt)) trace(*scattered);
    return sum_;
}

void PathTracedIntegrator::trace(PathState path) {
    while (path.throughput != Vec3(0)) {
        Hit hit;
        const bool met = world_.first_hit(path.ray, path.tolerance, path.kind, hit);
        const double distance =
            met ? length(hit.position - path.ray.origin) : std::numeric_limits<double>::infinity();
        if (pass_air(path, distance)) continue;
        if (!met) {
            sum_ += path.throughput * ends_.background(path);
            break;
        }
        if (ends_covered(path, hit, distance)) break;
        const Vertex vertex =
            vertex_at(world_, path.ray, hit, {path.media.data(), path.media.size()});
        // Chooses one of the mixed textures at random.
        double u = uniform(path.key, Purpose::texture_choice);
        PathState next = path;
        next.throughput = Vec3(0);
        for_visible_layers(world_, vertex, 0, [&](double weight, std::span<const Layer> layers) {
            if (u >= 0 && u < weight) {
                next = path;
                at_vertex(next, vertex, layers);
            }
            u -= weight;
        });
        path = next;
    }
}

/// Adds the radiance of fog and media along the path's ray, and attenuates the throughput. Returns
/// whether the path was scattered there and continues in another direction. Where media may scatter
/// the path for the first time, it goes on in both ways, so that media in front of a thing add no
/// noise to it.
bool PathTracedIntegrator::pass_air(PathState& path, double distance) {
    const Veil fog = veil_along(world_, path, distance);
    sum_ += path.throughput * fog.added;
    path.dim(fog.transmittance);
    if (!world_.has_media()) return false;
    const Veil veil = media_.along(path, distance, direct_light_, ledger_);
    sum_ += path.throughput * veil.added;
    const double scattered = path.bounces < max_bounces_ ? media_.scattering() : 0;
    if (scattered > 0) {
        const double chance = scattered / (scattered + max_component(veil.transmittance));
        const bool divides = !std::exchange(divided_, true);
        if (uniform(path.key, Purpose::media_event) < chance) {
            const PathState next = media_.scattered_path(path.dimmed(Vec3(1 / chance)));
            ++ledger_.scattered;
            if (!divides) {
                path = next;
                return true;
            }
            aside_ = next;
        } else if (!divides) {
            path.dim(Vec3(1 / (1 - chance)));
        }
    }
    path.dim(veil.transmittance);
    return false;
}

/// Adds the layers' emission and reflected direct light, and continues the path.
void PathTracedIntegrator::at_vertex(PathState& path, const Vertex& vertex,
                                     std::span<const Layer> layers) {
    if (world_.rules.quality < quality_light) {
        sum_ += path.throughput * layers.back().colour.rgb;
        path.throughput = Vec3(0);
        return;
    }
    const LayerStack stack(world_, path, vertex, layers);
    Ways ways;
    stack.visit([&](const LayerStack::Seen& layer) {
        gather(path.dimmed(layer.through), vertex, layer);
        add_ways(path, layer, ways);
    });
    if (stack.is_clear()) {
        // Total reflection takes the place of what would pass, so that all ways together have no
        // more than all light.
        const Vec3 left =
            left_inside(world_, path, vertex.hit) * stack.top().finish->refraction * stack.behind();
        ways.push_back({stack.reflects_totally() ? Way::total_reflection : Way::behind, stack.top(),
                        left, left});
    }
    assert(vertex.shading.both_sides || !std::ranges::all_of(layers, adds_no_light) ||
           max_component(std::accumulate(
               ways.begin(), ways.end(), Vec3(0),
               [](const Vec3& sum, const Way& way) { return sum + way.share; })) <= 1 + 1e-9);
    double all = 0;
    for (const Way& way : ways) all += max_component(glm::abs(way.share));
    double u = uniform(path.key, Purpose::way_choice) * all;
    for (const Way& way : ways) {
        const double own = max_component(glm::abs(way.share));
        if (u < own) {
            if (!follow(way, own / all, vertex, stack, path)) path.throughput = Vec3(0);
            return;
        }
        u -= own;
    }
    path.throughput = Vec3(0);
}

/// Whether reflected luminaires account for all light from the hit. If the scene has other light,
/// too, a random part of the paths continues in search of it.
bool PathTracedIntegrator::ends_covered(PathState& path, const Hit& hit, double distance) const {
    if (path.leaving > 0) {
        const double there = std::abs(dot(path.ray.direction, unit(hit.normal)));
        const double share = reflected_.share(path.leaving, there, distance);
        path.covered = uniform(path.key, Purpose::near_reflection) < share;
        path.leaving = 0;
    }
    if (!path.covered || !world_.has_other_light()) return path.covered;
    if (world_.material(hit.primitive).other_light) return false;
    if (uniform(path.key, Purpose::other_light) >= chance_of_covered_) return true;
    path.dim(Vec3(1 / chance_of_covered_));
    return false;
}

/// Adds the radiance that one layer emits and the direct light that it reflects.
void PathTracedIntegrator::gather(const PathState& seen, const Vertex& vertex,
                                  const LayerStack::Seen& layer) {
    const Vec3 own =
        own_radiance(layer.shading, rules_, shows_emission(world_, seen, vertex.hit.primitive));
    const Shading s = layer.scattering();
    record_seen(ledger_, world_, vertex.hit.primitive, seen.throughput * own);
    sum_ += seen.throughput * own;
    const PathState path = seen.dimmed(layer.below_mirror);
    const Bsdf whole(s, rules_);
    Vec3 light(0);
    const bool by_reflected = reflected_ && is_lambertian(world_, vertex, s);
    if (by_reflected && path.covered) {
        // What the diffuse part reflects of luminaires has been counted.
        EachKindOnce once;
        const Bsdf highlights = Bsdf::highlights_of(s, rules_);
        light +=
            direct_light_({vertex, highlights, once.take({LightKind::luminaires}), path.throughput},
                          path.key, ledger_);
        light += direct_light_(
            {vertex, whole, once.take({LightKind::sources, LightKind::sky}), path.throughput},
            path.key, ledger_);
    } else if (!scatters_inside(world_, s)) {
        light += direct_light_({vertex, whole, all_light, path.throughput}, path.key, ledger_);
        if (by_reflected && path.bounces < max_bounces_)
            light += reflected_(vertex, s, max_bounces_ - path.bounces, path.throughput, path.key,
                                ledger_);
    } else {
        const Bsdf highlights = Bsdf::highlights_of(s, rules_);
        light += direct_light_({vertex, highlights, all_light, path.throughput}, path.key, ledger_);
        light += light_from_inside(world_, direct_light_,
                                   {vertex, whole, all_light, path.throughput}, path, ledger_);
    }
    sum_ += path.throughput * light;
}

void PathTracedIntegrator::add_ways(const PathState& path, const LayerStack::Seen& layer,
                                    Ways& ways) const {
    const Shading scattering = layer.scattering();
    const auto add = [&](Way::Kind kind, const Vec3& through, const Vec3& share) {
        if (share != Vec3(0)) ways.push_back({kind, scattering, through, share});
    };
    const Vec3 through = layer.through * layer.below_mirror;
    std::optional<Microfacets> facets;
    if (scattering.finish->microfacet.on) facets.emplace(scattering);
    if (path.depth + 1 < world_.rules.settings.max_trace_level) {
        add(Way::mirror, layer.reflected, layer.reflected);
        if (facets && world_.rules.quality >= quality_reflection)
            add(Way::facets, through, through * facets->facets_albedo());
    }
    if (path.bounces < max_bounces_ && world_.rules.quality >= quality_full)
        add(Way::diffuse, through, through * diffuse_albedo(scattering, facets));
}

/// Continues the path in the way, which was chosen with probability `chance`. Returns false if the
/// path ends.
bool PathTracedIntegrator::follow(const Way& way, double chance, const Vertex& vertex,
                                  const LayerStack& stack, PathState& path) {
    double survival = 1;
    if (path.bounces >= first_roulette) {
        const double left = max_component(glm::abs(path.throughput * way.share)) / chance;
        survival = std::clamp(left, min_survival, 1.0);
    }
    path.covered &= way.kind == Way::diffuse && is_lambertian(world_, vertex, way.shading);
    if (path.covered && vertex.material->other_light) survival *= chance_of_covered_;
    if (survival < 1 && uniform(path.key, Purpose::roulette) >= survival) return false;
    ++ledger_.scattered;
    path.dim(way.through / (chance * survival));
    switch (way.kind) {
        case Way::mirror:
            path = mirrored_path(path, vertex, way.shading);
            path.dim(iridescence(way.shading, rules_, path.ray.direction));
            return path.depth < world_.rules.settings.max_trace_level;
        case Way::total_reflection:
            return reflect_totally(way.shading, vertex, path);
        case Way::facets:
            if (auto scattered = facet_path(path, vertex, way.shading)) {
                path = scattered->next;
                return true;
            }
            return false;
        case Way::diffuse:
            return bounce(way.shading, vertex, stack, path);
        case Way::behind:
            return go_behind(way.shading, vertex, stack, path);
    }
    return false;
}

/// Samples a direction for the diffuse part, on one side of the surface or on both. Returns false
/// if the path ends.
bool PathTracedIntegrator::bounce(const Shading& s, const Vertex& vertex, const LayerStack& stack,
                                  PathState& path) {
    const Bsdf bsdf(s, rules_);
    const auto direction = bsdf.sample_diffuse(
        {uniform(path.key, Purpose::bounce_u), uniform(path.key, Purpose::bounce_v)});
    const double density = direction ? bsdf.diffuse_pdf(*direction) : 0;
    if (!(density > 0)) return false;
    path.dim(bsdf.evaluate(*direction, diffuse_terms, 0) / (std::numbers::pi * density));
    path = gathering_path(path, vertex, *direction);
    if (reflected_ && !path.covered && is_lambertian(world_, vertex, s))
        path.leaving = dot(*direction, s.normal);
    const bool from_behind = dot(*direction, s.geometric_normal) < 0;
    if (from_behind && vertex.material->transparent) path.media = stack.interface().behind;
    return true;
}

bool PathTracedIntegrator::reflect_totally(const Shading& s, const Vertex& vertex,
                                           PathState& path) {
    // Light that was counted goes straight on instead.
    const bool counted = path.counted;
    path = mirrored_path(path, vertex, s);
    path.counted = counted;
    return path.depth < world_.rules.settings.max_trace_level;
}

bool PathTracedIntegrator::go_behind(const Shading& s, const Vertex& vertex,
                                     const LayerStack& stack, PathState& path) {
    const Interface& surface = stack.interface();
    const double ratio = refraction_ratio(path, surface);
    if (surface.bands > 0 && reflects_totally(s, ratio)) return reflect_totally(s, vertex, path);
    const bool straight = std::abs(ratio - 1) < 1e-10;
    const Vec3 direction = straight ? path.ray.direction : refracted_direction(s, ratio);
    const int depth = path.depth + (straight ? 0 : 1);
    path.go_on({vertex.position(), direction}, vertex.tolerance(), Branch::refraction);
    path.depth = depth;
    path.media = surface.behind;
    // As in POV-Ray, a ray that continues straight on requires one more trace level.
    return ++path.passed <= max_surfaces_along &&
           depth + (straight ? 1 : 0) < world_.rules.settings.max_trace_level;
}

}  // namespace candelabra
