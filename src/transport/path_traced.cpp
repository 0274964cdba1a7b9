// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/path_traced.h"

#include "scattering/phong.h"
#include "surface/quality.h"
#include "transport/atmosphere.h"
#include "transport/light_in_air.h"
#include "transport/subsurface.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace candelabra {

namespace {

/// Number of diffuse bounces from which on paths are subject to Russian roulette by throughput.
constexpr int first_roulette = 2;
/// Survival probability of a path for which reflected luminaires account for all light except that
/// of highlights and mirrors.
constexpr double chance_of_shine = 0.25;
/// Number of shadow rays to reflected luminaires at a hit that no diffuse reflection has led to: a
/// generation's cells and the path before the hit cost more than these. See "Indirect light".
constexpr int rays_before_bounces = 4;
/// Minimum survival probability in Russian roulette.
constexpr double min_survival = 0.05;

}  // namespace

PathTracedIntegrator::PathTracedIntegrator(const Shot& shot, const Tracing& wanted)
    : world_(*shot.world),
      rules_(shading_rules(world_)),
      photons_(wanted.sent->photons),
      direct_light_(shot, wanted.shadow_rays),
      reflected_(wanted.sent->reflected),
      media_(shot),
      ends_(shot, wanted.clear_sky, wanted.from_anywhere),
      ledger_(empty_ledger(world_, wanted.counts_lights, wanted.keeps_lamps)),
      max_bounces_(std::get<PathTraced>(world_.rules.settings.integrator).bounces),
      in_air_(reflected_.in_air()),
      lamps_only_(in_air_ ? lamps_light_air(world_) : world_.facts.is_lit_by_lamps_only),
      others_(world_.appearance.any_other_light || !lamps_only_),
      chance_of_covered_(lamps_only_ ? chance_of_shine : 1) {}

Rgb PathTracedIntegrator::radiance(const Ray& ray, const Key& key) {
    const PathState path = begin(ray, key);
    if (ray.direction == Vec3(0)) return sum_;
    ++ledger_.camera;
    trace(path);
    return end();
}

Rgb PathTracedIntegrator::element_radiance(const WhiteElement& element, const Key& key) {
    PathState path = begin(element.ray(), key);
    // The path changes while the vertex refers to the solids around it.
    const MediaStack around = path.media;
    if (at_vertex(path, element.vertex({around.data(), around.size()}), element.layers()))
        trace(path);
    return end();
}

PathState PathTracedIntegrator::begin(const Ray& ray, const Key& key) {
    sum_ = ledger_.glow = Rgb(0);
    direct_light_.use(photons_.begin(key.sample));
    reflected_.begin(key.sample);
    divided_ = false;
    return ends_.begin(ray, key);
}

/// Follows what media have scattered aside, and returns the radiance of the sample.
Rgb PathTracedIntegrator::end() {
    if (const auto scattered = std::exchange(aside_, std::nullopt)) trace(*scattered);
    return sum_;
}

void PathTracedIntegrator::trace(PathState path) {
    while (path.throughput != Rgb(0)) {
        Hit hit;
        const bool met = world_.first_hit(path.ray, path.tolerance, path.kind, hit);
        const double distance =
            met ? length(hit.position - path.ray.origin) : std::numeric_limits<double>::infinity();
        if (pass_air(path, distance)) continue;
        if (!met) {
            sum_ += path.throughput * ends_.background(path, ledger_);
            break;
        }
        if (ends_covered(path, hit, distance)) break;
        const Vertex vertex =
            vertex_at(world_, path.ray, hit, {path.media.data(), path.media.size()});
        const auto textures = visible_textures(world_, vertex);
        const auto* texture = choose(textures, uniform(path.key, Purpose::texture_choice));
        if (!texture || !at_vertex(path, vertex, texture->layers)) break;
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
    if (!world_.facts.has_media) return false;
    const Veil veil = media_.along(path, distance, direct_light_, ledger_,
                                   in_air_ ? &reflected_ : nullptr, max_bounces_ - path.bounces);
    sum_ += path.throughput * veil.added;
    const double scattered = path.bounces < max_bounces_ ? media_.scattering(others_) : 0;
    if (scattered > 0) {
        const double chance = scattered / (scattered + max_component(veil.transmittance));
        const bool divides = !std::exchange(divided_, true);
        if (uniform(path.key, Purpose::media_event) < chance) {
            const PathState next = scattered_path(path.dimmed(Rgb(1 / chance)));
            ledger_.scattered += next.throughput != Rgb(0) ? 1 : 0;
            if (!divides) {
                path = next;
                return true;
            }
            aside_ = next;
        } else if (!divides) {
            path.dim(Rgb(1 / (1 - chance)));
        }
    }
    path.dim(veil.transmittance);
    return false;
}

/// The path that media scatter. If reflected luminaires account for its light, a random part of the
/// paths continues in search of other light; others have a throughput of 0.
PathState PathTracedIntegrator::scattered_path(const PathState& path) const {
    PathState next = media_.scattered_path(path, others_);
    if (!next.taken.by_reflected) return next;
    const bool ends = uniform(path.key, Purpose::other_light) >= chance_of_covered_;
    return next.dimmed(Rgb(ends ? 0 : 1 / chance_of_covered_));
}

/// Adds the layers' emission and reflected direct light, and continues the path. Returns false if
/// it ends.
bool PathTracedIntegrator::at_vertex(PathState& path, const Vertex& vertex, const Layers& layers) {
    if (world_.rules.quality < quality_light) {
        sum_ += path.throughput * layers.back().colour.rgb;
        return false;
    }
    const LayerStack stack(world_, path, vertex, layers);
    SurfaceLobes lobes(world_, rules_, path, vertex, stack);
    const LobeKinds wanted = wanted_lobes(path);
    stack.visit([&](const LayerStack::Seen& layer) {
        gather(path.dimmed(layer.through), vertex, layer);
        lobes.add(layer, wanted);
    });
    lobes.add_behind();
    return go_on(lobes, vertex, path);
}

/// Whether reflected luminaires account for all light from the hit. If the scene has other light,
/// too, a random part of the paths continues in search of it.
bool PathTracedIntegrator::ends_covered(PathState& path, const Hit& hit, double distance) const {
    if (path.taken.cosine > 0) {
        const Vec3 normal = unit(hit.normal);
        const double there = -dot(path.ray.direction, normal);
        const double share = reflected_.share(hit.position, there < 0 ? -normal : normal,
                                              path.taken.cosine, std::abs(there), distance);
        path.taken.by_reflected = uniform(path.key, Purpose::near_reflection) < share;
        path.taken.cosine = 0;
    }
    if (!path.taken.by_reflected || !others_) return path.taken.by_reflected;
    if (world_.material(hit.primitive).other_light) return false;
    if (uniform(path.key, Purpose::other_light) >= chance_of_covered_) return true;
    path.dim(Rgb(1 / chance_of_covered_));
    return false;
}

/// Adds the radiance that one layer emits and the direct light that it reflects.
void PathTracedIntegrator::gather(const PathState& seen, const Vertex& vertex,
                                  const LayerStack::Seen& layer) {
    const Rgb own =
        own_radiance(layer.shading, rules_, shown_emission(world_, seen, vertex.hit.primitive));
    const Shading s = layer.scattering();
    record_seen(ledger_, world_, vertex.hit.primitive, seen.throughput * own);
    record_glow(ledger_, seen, seen.throughput * own);
    sum_ += seen.throughput * own;
    const PathState path = seen.dimmed(layer.below_mirror);
    const Bsdf whole(s, rules_);
    const auto lit = [&](const Bsdf& bsdf, LightKinds kinds) -> LitLayer {
        return {.vertex = vertex,
                .scatterer = bsdf,
                .light = kinds,
                .throughput = path.throughput,
                .samples_grids = path.bounces > 0};
    };
    Rgb light(0);
    if (path.taken.by_reflected && is_even_on_each_side(world_, vertex, s)) {
        // What the diffuse part reflects has been counted, except for what photons bring.
        const Bsdf highlights = Bsdf::highlights_of(s, rules_);
        light += direct_light_(lit(highlights, all_light), path.key, ledger_);
        LitLayer diffuse = lit(whole, all_light);
        diffuse.highlights = false;
        light += direct_light_.by_photons(diffuse, path.key, ledger_);
    } else if (!scatters_inside(world_, s)) {
        light += direct_light_(lit(whole, all_light), path.key, ledger_);
        if (reflected_ && is_lambertian(world_, vertex, s) && path.bounces < max_bounces_)
            light += reflected_({world_, lit(whole, all_light), false, ledger_},
                                {max_bounces_ - path.bounces,
                                 path.scattered ? std::nullopt : std::optional<Scatterer>(whole),
                                 path.bounces == 0 ? rays_before_bounces : 1},
                                path.key);
    } else {
        const Bsdf highlights = Bsdf::highlights_of(s, rules_);
        light += direct_light_(lit(highlights, all_light), path.key, ledger_);
        light += light_from_inside(world_, direct_light_, lit(whole, all_light), path, ledger_);
    }
    sum_ += path.throughput * light;
}

/// Whether mirrors and glass may send the path on. As in POV-Ray, also a ray that continues
/// straight on requires one more level.
bool PathTracedIntegrator::goes_deeper(const PathState& path) const {
    return path.depth + 1 < world_.rules.settings.max_trace_level;
}

LobeKinds PathTracedIntegrator::wanted_lobes(const PathState& path) const {
    const bool deeper = goes_deeper(path);
    return {.mirror = deeper,
            .facets = deeper && world_.rules.quality >= quality_reflection,
            .diffuse = path.bounces < max_bounces_ && world_.rules.quality >= quality_full};
}

/// Continues the path in one lobe, chosen at random. Returns false if the path ends.
bool PathTracedIntegrator::go_on(const SurfaceLobes& lobes, const Vertex& vertex, PathState& path) {
    const auto chosen = lobes.choose(uniform(path.key, Purpose::way_choice));
    if (!chosen) return false;
    const auto& [lobe, chance] = *chosen;
    double survival = 1;
    if (path.bounces >= first_roulette) {
        const double left = max_abs_component(path.throughput * lobe.share) / chance;
        survival = std::clamp(left, min_survival, 1.0);
    }
    const bool diffuse = lobe.kind == LobeKind::diffuse;
    path.taken.by_reflected &= diffuse && is_even_on_each_side(world_, vertex, lobe.shading);
    if (path.taken.by_reflected && vertex.material->other_light) survival *= chance_of_covered_;
    if (survival < 1 && uniform(path.key, Purpose::roulette) >= survival) return false;
    ++ledger_.scattered;
    path.dim(lobe.through / (chance * survival));
    const bool deeper = goes_deeper(path);
    if (!lobes.follow(lobe, path) || !(diffuse || deeper) || path.passed > max_surfaces_along)
        return false;
    if (reflected_ && diffuse && is_lambertian(world_, vertex, lobe.shading) &&
        !path.taken.by_reflected)
        path.taken.cosine = dot(path.ray.direction, lobe.shading.normal);
    return true;
}

}  // namespace candelabra
