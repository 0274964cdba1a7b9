// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/povray.h"

#include "base/cosine_direction.h"
#include "base/elementary.h"
#include "scattering/microfacet.h"
#include "scattering/mirror.h"
#include "scattering/phong.h"
#include "surface/quality.h"
#include "transport/atmosphere.h"
#include "transport/layer_stack.h"
#include "transport/path_steps.h"
#include "transport/subsurface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace candelabra {

namespace {

/// Number of strata of the directions of gathered light along each of two axes, for light that
/// reaches the eye undimmed: "The price of radiosity".
constexpr double gathering_strata = 2;

/// Fewer where less of the light reaches the eye, and one after the first reflection.
std::uint32_t strata_of(const PathState& path) {
    if (path.bounces > 0) return 1;
    const double left = std::clamp(max_component(path.throughput), 0.0, 1.0);
    return static_cast<std::uint32_t>(std::fmax(std::ceil(std::sqrt(left) * gathering_strata), 1));
}

}  // namespace

PovRayIntegrator::PovRayIntegrator(const Shot& shot, const Tracing& wanted)
    : world_(*shot.world),
      radiosity_(world_.rules.settings.radiosity),
      rules_(shading_rules(world_)),
      photons_(wanted.sent->photons),
      direct_light_(shot, wanted.shadow_rays),
      media_(shot),
      ends_(shot, wanted.clear_sky, wanted.from_anywhere),
      ledger_(empty_ledger(world_, wanted.counts_lights, wanted.keeps_lamps)),
      max_rays_(wanted.max_rays) {}

Rgb PovRayIntegrator::radiance(const Ray& ray, const Key& key) {
    const PathState path = ends_.begin(ray, key);
    direct_light_.use(photons_.begin(key.sample));
    rays_ = 0;
    ledger_.glow = Rgb(0);
    if (ray.direction == Vec3(0)) return Rgb(0);
    ++ledger_.camera;
    return follow(path);
}

Rgb PovRayIntegrator::element_radiance(const WhiteElement& element, const Key& key) {
    const PathState path = ends_.begin(element.ray(), key);
    direct_light_.use(photons_.begin(key.sample));
    rays_ = 0;
    const Vertex vertex = element.vertex({path.media.data(), path.media.size()});
    return layered(path, vertex, element.layers());
}

Rgb PovRayIntegrator::follow(const PathState& path) {
    if (path.depth >= world_.rules.settings.max_trace_level ||
        path.weight < world_.rules.settings.adc_bailout || ++rays_ > max_rays_)
        return Rgb(0);
    Hit hit;
    const bool met = world_.first_hit(path.ray, path.tolerance, path.kind, hit);
    const bool airless = path.kind == RayKind::gathering && !radiosity_.media;
    if (!world_.facts.dims_between || airless)
        return met ? surface(path, hit) : ends_.background(path, ledger_);
    const double distance =
        met ? length(hit.position - path.ray.origin) : std::numeric_limits<double>::infinity();
    const Veil air = veil_along(world_, path, distance);
    const Veil veil =
        air.before(media_.along(path.dimmed(air.transmittance), distance, direct_light_, ledger_));
    const PathState behind = path.dimmed(veil.transmittance);
    return veil.through(met ? surface(behind, hit) : ends_.background(behind, ledger_));
}

/// Radiance of all textures that are mixed at a hit.
Rgb PovRayIntegrator::surface(const PathState& path, const Hit& hit) {
    const Vertex vertex = vertex_at(world_, path.ray, hit, {path.media.data(), path.media.size()});
    Rgb sum(0);
    const double least = world_.rules.settings.adc_bailout;
    for (const auto& [weight, layers] : visible_textures(world_, vertex, least))
        sum += weight * layered(path.dimmed(Rgb(weight)), vertex, layers);
    return sum;
}

/// Radiance of a stack of layers: each layer through those above it, the reflections of all, and
/// light from behind.
Rgb PovRayIntegrator::layered(const PathState& path, const Vertex& vertex, const Layers& layers) {
    if (world_.rules.quality < quality_light) return layers.back().colour.rgb;
    const LayerStack stack(world_, path, vertex, layers);
    const double emission = shown_emission(world_, path, vertex.hit.primitive);
    Rgb result(0);
    stack.visit([&](const LayerStack::Seen& layer) {
        const Shading& s = layer.shading;
        const Finish& finish = *s.finish;
        const PathState below = path.dimmed(layer.through);
        result += layer.through * lit(below, vertex, s, emission);
        if (layer.reflected != Rgb(0)) {
            const double weight =
                layer.weight * greatest_reflectivity(finish.reflection, layer.reflected);
            result += finish.reflection.exponent == 1
                          ? reflected(path, vertex, s, layer.reflected, weight)
                          : reflected_to_a_power(path, vertex, s, layer.reflected, weight);
        }
        if (finish.microfacet.on && world_.rules.quality >= quality_reflection)
            result += layer.through * scattered(below, vertex, s, layer.weight);
    });
    const bool total = stack.reflects_totally();
    if (!total && !stack.is_clear()) return result;
    const Shading& top = stack.top();
    const Rgb& behind = stack.behind();
    const Rgb left = left_inside(world_, path, vertex.hit) * top.finish->refraction;
    const PathState inside = path.dimmed(left);
    // Total reflection: no light is lost, but the ray has the weight of a transmitted one.
    if (total)
        return result + left * reflected(inside, vertex, top, Rgb(1), max_abs_component(behind));
    const Interface& surface = stack.interface();
    return result + left * (surface.bands > 0 ? split(inside, vertex, top, surface, behind)
                                              : transmitted(inside, vertex, top, surface, behind));
}

/// Radiance that one layer emits and reflects of direct light, before the layers above attenuate
/// it.
Rgb PovRayIntegrator::lit(const PathState& path, const Vertex& vertex, const Shading& s,
                          double emission) {
    const Rgb own = own_radiance(s, rules_, emission);
    record_seen(ledger_, world_, vertex.hit.primitive, path.throughput * own);
    record_glow(ledger_, path, path.throughput * own);
    // Gathered light shows no highlights. The last gathering includes light sources; light of
    // luminaires was counted before.
    const bool highlights = path.bounces == 0,
               luminaires =
                   !world_.facts.gathers_light || path.bounces < radiosity_.recursion_limit;
    if (!scatters_inside(world_, s)) {
        const Bsdf bsdf(s, rules_);
        if (!world_.facts.gathers_light)
            return own +
                   direct_light_({vertex, bsdf, all_light, path.throughput}, path.key, ledger_);
        return own +
               direct_light_({.vertex = vertex,
                              .scatterer = bsdf,
                              .light = all_sources,
                              .throughput = path.throughput,
                              .highlights = highlights,
                              .samples_grids = path.bounces > 0},
                             path.key, ledger_) +
               (luminaires ? gathered(path, vertex, s) : Rgb(0));
    }
    const Bsdf whole(s, rules_), shine = Bsdf::highlights_of(s, rules_);
    return own + direct_light_({vertex, shine, all_light, path.throughput}, path.key, ledger_) +
           light_from_inside(world_, direct_light_, {vertex, whole, all_light, path.throughput},
                             path, ledger_);
}

/// Light of other surfaces that the diffuse part reflects: POV-Ray's radiosity, with rays for each
/// side that reflects.
Rgb PovRayIntegrator::gathered(const PathState& path, const Vertex& vertex, const Shading& s) {
    const Finish& f = *s.finish;
    const double front = f.microfacet.on ? Microfacets(s).base_albedo() : f.diffuse;
    const auto side = [&](double share, bool behind) {
        const Rgb amount = s.colour.rgb * (s.opacity * share);
        if (!(share > 0) || amount == Rgb(0)) return Rgb(0);
        return amount * gathered_from(path.dimmed(amount), vertex, s, behind);
    };
    // Luminaires are sampled as elsewhere. Only one side of a surface gathers light, unless the
    // surface has a second diffuse value.
    Shading one_side = s;
    one_side.both_sides = false;
    const Bsdf bsdf(one_side, rules_);
    const Rgb straight = direct_light_({.vertex = vertex,
                                        .scatterer = bsdf,
                                        .light = {LightKind::luminaires, LightKind::sky},
                                        .throughput = path.throughput,
                                        .highlights = path.bounces == 0,
                                        .radiosity = &radiosity_},
                                       path.key, ledger_);
    return straight + side(front, false) + side(f.microfacet.on ? 0 : f.diffuse_back, true);
}

/// Estimate of the cosine-weighted mean radiance over the directions of one side, by rays whose
/// directions are stratified.
Rgb PovRayIntegrator::gathered_from(const PathState& path, const Vertex& vertex, const Shading& s,
                                    bool behind) {
    const Vec3 seen = radiosity_.normal ? s.normal : s.smooth_normal;
    const Vec3 surface = behind ? -s.geometric_normal : s.geometric_normal;
    const std::uint32_t strata = strata_of(path);
    const double share = 1.0 / (strata * strata);
    Rgb sum(0);
    for (std::uint32_t i = 0; i < strata * strata; ++i) {
        const Key key = path.key.branched(Branch::diffuse, 2 * i + (behind ? 1 : 0));
        const Vec2 place{(i % strata + uniform(key, Purpose::bounce_u)) / strata,
                         (i / strata + uniform(key, Purpose::bounce_v)) / strata};
        Vec3 direction = cosine_direction(behind ? -seen : seen, place);
        // No light comes from below the real surface; such a direction is replaced by its mirror
        // image.
        if (dot(direction, surface) < 0) direction = mirrored(direction, surface);
        const PathState dimmed = path.dimmed(Rgb(radiosity_.brightness * share));
        PathState next = behind ? gathering_path_behind(world_, dimmed, vertex, direction)
                                : gathering_path(dimmed, vertex, direction);
        next.key = key;
        ++ledger_.scattered;
        sum += gathered_light(radiosity_, follow(next));
    }
    return sum * share;
}

Rgb PovRayIntegrator::reflected(const PathState& path, const Vertex& vertex, const Shading& s,
                                const Rgb& amount, double weight) {
    PathState next = mirrored_path(path, vertex, s);
    next.weight = path.weight * weight;
    ++ledger_.scattered;
    const Rgb tinted = amount * iridescence(s, rules_, next.ray.direction);
    return tinted * follow(next.dimmed(tinted));
}

Rgb PovRayIntegrator::reflected_to_a_power(const PathState& path, const Vertex& vertex,
                                           const Shading& s, const Rgb& amount, double weight) {
    PathState next = mirrored_path(path, vertex, s);
    next.weight = path.weight * weight;
    ++ledger_.scattered;
    // A power of a sum has no summands that could be attributed to lights.
    const Rgb shown = iridescence(s, rules_, next.ray.direction) * follow(next.dimmed(Rgb(0)));
    const auto dimmed = [&](double channel) {
        return channel > 0 ? math::pow(channel, 1 / s.finish->reflection.exponent) : 0.0;
    };
    return amount * Rgb(dimmed(shown.r), dimmed(shown.g), dimmed(shown.b));
}

/// Radiance that microfacets reflect, except for the part that direct_light_ includes.
Rgb PovRayIntegrator::scattered(const PathState& path, const Vertex& vertex, const Shading& s,
                                double weight) {
    auto scattered = facet_path(path, vertex, s);
    if (!scattered) return Rgb(0);
    scattered->next.weight = path.weight * weight * max_component(scattered->share);
    ++ledger_.scattered;
    return scattered->share * follow(scattered->next);
}

/// White light, with a separate path for each of its bands. As in POV-Ray, bands that are totally
/// reflected are coloured like the others.
Rgb PovRayIntegrator::split(const PathState& path, const Vertex& vertex, const Shading& s,
                            const Interface& surface, const Rgb& share) {
    Rgb sum(0);
    for (int i = 0; i < surface.bands; ++i) {
        const SpectralBand band{i, surface.bands};
        PathState coloured = path.dimmed(hue(band) / static_cast<double>(surface.bands));
        coloured.band = band;
        Interface own = surface;
        own.ratio *= math::pow(surface.dispersion, band.power());
        sum += hue(band) * (reflects_totally(s, own.ratio)
                                ? reflected(coloured, vertex, s, share, max_component(abs(share)))
                                : transmitted(coloured, vertex, s, own, share));
    }
    return sum / static_cast<double>(surface.bands);
}

Rgb PovRayIntegrator::transmitted(const PathState& path, const Vertex& vertex, const Shading& s,
                                  const Interface& surface, const Rgb& share) {
    // As in POV-Ray, also a ray that continues straight on requires one more level.
    if (path.depth + 1 >= world_.rules.settings.max_trace_level) return Rgb(0);
    PathState next = path_behind(path.dimmed(share), vertex, s, surface, surface.ratio);
    if (next.passed > max_surfaces_along) return Rgb(0);
    next.weight = path.weight * max_abs_component(share);
    ++ledger_.scattered;
    return share * follow(next);
}

}  // namespace candelabra
