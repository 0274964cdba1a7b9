// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/trace.h"

#include "render/microfacet.h"
#include "render/subsurface.h"
#include "surface/simplified.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace {

enum Bounce : std::uint32_t { reflection, refraction, scattering };

/// For as long as it lives, what is asked for has so much less of a share in the sample.
class Scaled {
public:
    Scaled(RayCounts& rays, const Vec3& factor)
        : rays_(rays), share_(rays.share), clear_(rays.clear) {
        rays.share *= factor;
        rays.clear *= std::min(1.0, std::abs(grey(factor)));
    }
    Scaled(const Scaled&) = delete;
    Scaled& operator=(const Scaled&) = delete;
    ~Scaled() {
        rays_.share = share_;
        rays_.clear = clear_;
    }

private:
    RayCounts& rays_;
    Vec3 share_;
    double clear_;
};

/// What the weight of a reflected ray counts, in the direction that reflects most.
double most_reflected(const Reflection& reflection, const Vec3& amount) {
    return reflection.fresnel
               ? max_component(amount)
               : std::max(max_component(reflection.least), max_component(reflection.greatest));
}

/// Where the pattern of a camera's normal is asked for a point of the picture. Measured from
/// POV-Ray: a coordinate that stands for an angle is that angle in radians; round pictures have
/// the angle around their middle and the angle away from it.
Vec3 bump_place(const Projection& camera, double u, double v) {
    const double width = length(camera.right), height = length(camera.up);
    switch (camera.lens) {
        case Lens::fisheye:
        case Lens::omnimax: {
            const Vec3 towards = camera.ray(u, v).direction;
            const double away = std::acos(dot(unit(camera.direction), towards));
            const double around =
                std::atan2(dot(camera.up, towards) / height, dot(camera.right, towards) / width);
            // Counted from a quarter of a turn below, as POV-Ray does.
            const bool low = around < -0.5 * std::numbers::pi;
            return {low ? around + 2 * std::numbers::pi : around, away, 0};
        }
        case Lens::ultra_wide:
            return {u * camera.angle, v * camera.angle * height / width, 0};
        case Lens::panoramic:
            return {std::numbers::pi * (0.5 - u), std::numbers::pi * v, 0};
        case Lens::cylinder1:
        case Lens::cylinder3:
            return {u * camera.angle, v * height, 0};
        case Lens::cylinder2:
        case Lens::cylinder4:
            return {u * width, v * camera.angle, 0};
        case Lens::spherical:
            return {u * camera.angle, v * camera.vertical_angle, 0};
        case Lens::flat:
        case Lens::parallel:
        case Lens::mesh:
            break;
    }
    return {u, v, 0};
}

}  // namespace

Ray pinhole_ray(const World& world, double u, double v) {
    Ray ray = world.view.camera.ray(u, v);
    if (ray.direction != Vec3(0) && world.view.camera_normal.pattern)
        ray.direction = bumped(world.view.camera_normal, ray.direction,
                               bump_place(world.view.camera, u, v), world.pattern_scene());
    return ray;
}

Ray camera_ray(const World& world, double u, double v, const Key& key) {
    const Ray ray = pinhole_ray(world, u, v);
    if (ray.direction == Vec3(0) || world.view.camera.lens_radius == 0) return ray;
    return world.view.camera.through_lens(
        ray, {uniform(key, Purpose::lens_u), uniform(key, Purpose::lens_v)});
}

Tracer::Tracer(const World& world, const Tracing& wanted)
    : world_(world), direct_light_(world, wanted.shadow_rays), clear_sky_(wanted.clear_sky) {
    if (wanted.counts_lights) rays_.lights.resize(world.provenance.light_statements.size() + 1);
    if (world.notes_solids() && !world.view.camera.parallel)
        around_camera_ = world.containing(world.view.camera.location);
}

Vec3 Tracer::radiance(const Ray& ray, const Key& key) {
    clear_ = 0;
    if (ray.direction == Vec3(0)) return Vec3(0);
    ++rays_.camera;
    Path path;
    path.ray = ray;
    path.key = key;
    path.solids = world_.notes_solids() && world_.view.camera.parallel
                      ? world_.containing(ray.origin)
                      : around_camera_;
    return follow(path);
}

const Interior& Tracer::interior(const Solids& solids) const {
    static const Interior atmosphere{.ior = 1};
    if (solids.empty()) return atmosphere;
    const auto& inside = world_.material(solids.back()).interior;
    return inside ? *inside : atmosphere;
}

Tracer::Interface Tracer::interface_at(const Path& path, PrimitiveIndex primitive) const {
    Interface result{1, 1, path.solids};
    Solids& behind = result.behind;
    const auto inside = std::ranges::find(behind, world_.solid(primitive),
                                          [&](PrimitiveIndex p) { return world_.solid(p); });
    const bool leaving = inside != behind.end();
    if (!leaving) {
        behind.push_back(primitive);
    } else {
        const bool innermost = inside + 1 == behind.end();
        behind.erase(inside);
        if (!innermost) return result;  // leaving one of two that overlap bends nothing
    }
    const Interior &here = interior(path.solids), &there = interior(behind);
    result.ratio = here.ior / there.ior;
    // Who leaves one solid in another sees no `fresnel` reflection in POV-Ray 3.7.
    result.plain = leaving && !behind.empty() ? 1 : result.ratio;
    result.dispersion = here.dispersion / there.dispersion;
    if (result.dispersion == 1) return result;
    if (path.band)
        result.ratio *= std::pow(result.dispersion, path.band->power());
    else
        result.bands = (here.dispersion != 1 ? here : there).dispersion_samples;
    return result;
}

bool Tracer::in_the_open(const Path& path) const {
    return std::ranges::all_of(path.solids,
                               [&](PrimitiveIndex solid) { return world_.material(solid).hollow; });
}

Vec3 Tracer::follow(const Path& path) {
    if (path.level >= world_.rules.settings.max_trace_level ||
        path.weight < world_.rules.settings.adc_bailout)
        return Vec3(0);
    Hit hit;
    const bool met = world_.first_hit(path.ray, path.tolerance, path.kind, hit);
    if (!world_.has_air() || !in_the_open(path)) return met ? surface(path, hit) : beyond(path);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double distance = met ? length(hit.position - path.ray.origin) : infinity;
    // What share is left tells how many shadow rays are worth their while.
    const bool splits = clear_sky_ || !rays_.lights.empty() || world_.light_is_drawn();
    const Vec3 left =
        splits ? veiled(path, distance, Vec3(1)) - veiled(path, distance, Vec3(0)) : Vec3(1);
    const Scaled scaled(rays_, left);
    return veiled(path, distance, met ? surface(path, hit) : beyond(path));
}

/// What is seen of what is so far away.
Vec3 Tracer::veiled(const Path& path, double distance, const Vec3& seen) const {
    const Vec3 behind = world_.sky.rainbows.empty()
                            ? seen
                            : arched(world_.sky.rainbows, path.ray, distance, seen,
                                     uniform(path.key, Purpose::rainbow));
    return fogged(world_.sky.fogs, path.ray, distance, behind,
                  world_.pattern_scene().noise_generator);
}

/// What lies behind everything.
Vec3 Tracer::beyond(const Path& path) {
    if (path.counted && !world_.sky.light.empty()) return Vec3(0);
    const Vec3& direction = path.ray.direction;
    if (!clear_sky_) return world_.sky_radiance(direction);
    if (path.kind != RayKind::camera)
        return world_.sky_radiance(direction, world_.sky.background.mirrored());
    clear_ += rays_.clear * world_.sky_clear(direction);
    if (world_.rules.language_version < 3.7) return Vec3(0);
    return world_.sky_radiance(direction, world_.sky.background.covering());
}

/// Notes what a luminaire shows that is seen itself.
void Tracer::credit(const Hit& hit, const Vec3& shown) {
    if (rays_.lights.empty() || world_.lights.luminaires.empty()) return;
    const LightIndex light = world_.lights.luminaire_of[hit.primitive];
    if (light != no_primitive)
        rays_.lights[world_.provenance.statement_of_luminaire[light]].seen += rays_.share * shown;
}

void Tracer::take_lights(FunctionRef<void(std::size_t statement, const Vec3&)> use) {
    for (std::size_t i = 0; i + 1 < rays_.lights.size(); ++i)
        use(i, std::exchange(rays_.lights[i].seen, Vec3(0)));
}

/// What all textures that are mixed at a hit show together.
Vec3 Tracer::surface(const Path& path, const Hit& hit) {
    Shading s = shading_at(world_, path.ray, hit);
    s.around = {path.solids.data(), path.solids.size()};
    const SurfacePlace place(world_, hit, s);
    Vec3 sum(0);
    const auto show = [&](double share, const Texture& texture) {
        if (share < world_.rules.settings.adc_bailout) return;
        for_layers(texture, s.position, s.normal, place.scene,
                   [&](double weight, std::span<const Layer> layers) {
                       const Scaled scaled(rays_, Vec3(share * weight));
                       sum += share * weight * layered(path, hit, s, layers);
                   });
    };
    for_textures_seen(world_, hit, dot(hit.normal, path.ray.direction) > 0, show);
    return sum;
}

/// What a stack of layers shows: each through those above it, reflections of all, and what is
/// behind.
Vec3 Tracer::layered(const Path& path, const Hit& hit, const Shading& common,
                     std::span<const Layer> layers) {
    if (world_.rules.quality < quality_light) return layers.back().colour.rgb;
    const double bailout = world_.rules.settings.adc_bailout;
    const bool transparent = world_.material(hit.primitive).transparent;
    const bool asks = transparent || std::ranges::any_of(layers, [](const Layer& layer) {
                          return layer.finish->reflection.fresnel;
                      });
    const Interface surface = asks ? interface_at(path, hit.primitive) : Interface{1, 1, {}};
    const auto kept = [&](const Shading& s) {
        const Vec3 clear = s.colour.passing();
        return s.finish->conserve_energy
                   ? clear * glm::clamp(Vec3(1) - reflectivity(s, surface.plain), Vec3(0), Vec3(1))
                   : clear;
    };
    Vec3 behind(transparent ? 1 : 0);
    if (transparent)
        for (const Layer& layer : layers) behind *= kept(with_layer(world_, common, layer));
    // A negative share, which takes away what is behind, counts like a positive one.
    const bool clear = std::abs(grey(behind)) > bailout && world_.rules.quality >= quality_pigments;
    const bool counted = path.counted && !world_.lights.luminaires.empty() &&
                         world_.lights.luminaire_of[hit.primitive] != no_primitive;
    const Shading top = with_layer(world_, common, layers.front());
    const double cosine = -dot(top.view, top.normal);
    const bool total =
        clear && surface.bands == 0 && surface.ratio * surface.ratio * (1 - cosine * cosine) > 1;
    Vec3 result(0), through(1);
    for (const Layer& layer : layers) {
        const bool first = &layer == layers.data();
        const double share = first ? 1 : grey(through);
        if (share <= bailout) break;
        const Shading s = first ? top : with_layer(world_, common, layer);
        result += through * lit(path, hit, s, through, !counted);
        // Total reflection stands for that of all layers with the normal by which it happens.
        const bool replaced = total && s.normal == top.normal;
        const bool reflects = !replaced && world_.rules.quality >= quality_reflection;
        const Vec3 amount = reflects ? reflectivity(s, surface.plain) : Vec3(0);
        if (amount != Vec3(0))
            result +=
                reflected(path, s, amount, share * most_reflected(s.finish->reflection, amount),
                          s.finish->reflection.exponent);
        if (s.finish->microfacet.on && world_.rules.quality >= quality_reflection)
            result += through * scattered(path, s, share, through);
        if (&layer != &layers.back()) through *= kept(s);
    }
    if (!total && !clear) return result;
    const Vec3 left = faded(path, hit) * top.finish->refraction;
    const Scaled scaled(rays_, left);
    // Total reflection: nothing is lost, but the ray is worth what one going through would be.
    if (total)
        return result + left * reflected(path, top, Vec3(1), max_component(glm::abs(behind)));
    return result + left * (surface.bands > 0 ? split(path, top, surface, behind)
                                              : transmitted(path, top, surface, behind));
}

/// What one layer sends by itself and of direct light, before the layers above it take their part.
Vec3 Tracer::lit(const Path& path, const Hit& hit, const Shading& s, const Vec3& through,
                 bool glowing) {
    const Scaled scaled(rays_, through);
    const Vec3 own = own_radiance(world_, s, glowing);
    credit(hit, own);
    if (!scatters_inside(world_, s)) return own + direct_light_(s, path.key, rays_);
    Shading shine = s;
    shine.only_shine = true;
    return own + direct_light_(shine, path.key, rays_) +
           light_from_inside(world_, direct_light_, hit, s, path.weight, path.key, rays_);
}

/// What the inside of a solid leaves of the light along the part of a ray that ends at its surface.
Vec3 Tracer::faded(const Path& path, const Hit& hit) const {
    const std::uint32_t left_behind = world_.solid(hit.primitive);
    const bool inside = std::ranges::any_of(
        path.solids, [&](PrimitiveIndex around) { return world_.solid(around) == left_behind; });
    const auto& interior = world_.material(hit.primitive).interior;
    if (!inside || !interior || interior->fade_distance == 0) return Vec3(1);
    return attenuation(*interior, length(hit.position - path.ray.origin));
}

Vec3 Tracer::reflected(const Path& path, const Shading& s, const Vec3& amount, double share,
                       double exponent) {
    Vec3 direction = mirrored(path.ray.direction, s.normal);
    // A bump may mirror the ray into the surface; the normal without bumps brings it out again.
    // Where the bump looks away from the viewer, POV-Ray does as if there were none. What a smooth
    // normal alone mirrors into the surface goes there.
    if (dot(direction, s.smooth_normal) < 0)
        direction = mirrored(dot(direction, s.normal) < 0 ? path.ray.direction : direction,
                             s.smooth_normal);
    Path next = path;
    next.ray = {s.position, unit(direction)};
    next.tolerance = s.tolerance;
    next.level = path.level + 1;
    next.weight = path.weight * share;
    next.kind = RayKind::reflected;
    next.counted = false;
    next.key = path.key.bounced(reflection);
    ++rays_.scattered;
    const Vec3 colours = iridescence(world_, s, next.ray.direction), tinted = amount * colours;
    // A power of a sum has no parts.
    const Scaled scaled(rays_, exponent == 1 ? tinted : Vec3(0));
    const Vec3 seen = follow(next);
    if (exponent == 1) return tinted * seen;
    const auto dimmed = [&](double channel) {
        return channel > 0 ? std::pow(channel, 1 / exponent) : 0.0;
    };
    const Vec3 shown = colours * seen;
    return amount * Vec3(dimmed(shown.x), dimmed(shown.y), dimmed(shown.z));
}

/// What small facets reflect, besides what direct_light_ has seen of it.
Vec3 Tracer::scattered(const Path& path, const Shading& s, double share, const Vec3& through) {
    const auto drawn =
        scatter(s, uniform(path.key, Purpose::facet_choice),
                {uniform(path.key, Purpose::facet_u), uniform(path.key, Purpose::facet_v)});
    if (!drawn || dot(drawn->direction, s.true_normal) <= 0) return Vec3(0);
    Path next = path;
    next.ray = {s.position, drawn->direction};
    next.tolerance = s.tolerance;
    next.level = path.level + 1;
    next.weight = path.weight * share * max_component(drawn->weight);
    next.kind = RayKind::reflected;
    next.counted = !drawn->narrow;
    next.key = path.key.bounced(scattering);
    ++rays_.scattered;
    const Scaled scaled(rays_, through * drawn->weight);
    return drawn->weight * follow(next);
}

/// White light, each of its bands on a way of its own. As in POV-Ray, bands that are reflected in
/// total are coloured like the others.
Vec3 Tracer::split(const Path& path, const Shading& s, const Interface& surface,
                   const Vec3& share) {
    Vec3 sum(0);
    const double cosine = -dot(s.view, s.normal);
    for (int i = 0; i < surface.bands; ++i) {
        Path coloured = path;
        coloured.band = SpectralBand{i, surface.bands};
        Interface own = surface;
        own.ratio *= std::pow(surface.dispersion, coloured.band->power());
        const bool total = own.ratio * own.ratio * (1 - cosine * cosine) > 1;
        const Scaled scaled(rays_, hue(*coloured.band) / static_cast<double>(surface.bands));
        sum += hue(*coloured.band) *
               (total ? reflected(coloured, s, share, max_component(glm::abs(share)))
                      : transmitted(coloured, s, own, share));
    }
    return sum / static_cast<double>(surface.bands);
}

Vec3 Tracer::transmitted(const Path& path, const Shading& s, const Interface& surface,
                         const Vec3& share) {
    const bool straight = std::abs(surface.ratio - 1) < 1e-10;
    // What goes straight on takes no level, but needs one that is left, as in POV-Ray.
    if (straight && path.level + 1 >= world_.rules.settings.max_trace_level) return Vec3(0);
    Path next = path;
    next.ray = {s.position, path.ray.direction};
    if (!straight) {
        // A disturbed normal that looks away from the viewer counts from its other side.
        const Vec3 normal = dot(s.view, s.normal) > 0 ? -s.normal : s.normal;
        const double cosine = -dot(s.view, normal);
        const double behind = std::sqrt(1 - surface.ratio * surface.ratio * (1 - cosine * cosine));
        next.ray.direction =
            unit(surface.ratio * s.view + (surface.ratio * cosine - behind) * normal);
    }
    next.tolerance = s.tolerance;
    next.level = path.level + (straight ? 0 : 1);
    next.passed = path.passed + 1;
    if (next.passed > max_clear_surfaces) return Vec3(0);
    next.weight = path.weight * max_component(glm::abs(share));
    next.key = path.key.bounced(refraction);
    next.solids = surface.behind;
    ++rays_.scattered;
    const Scaled scaled(rays_, share);
    return share * follow(next);
}
