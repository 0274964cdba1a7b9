// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shade.h"

#include <algorithm>
#include <numbers>

namespace {

using std::numbers::pi;

/// POV-Ray's fit of the metallic Fresnel curve: 0 straight on, 1 at grazing angles, and less again
/// beyond them, where a disturbed normal looks away.
double metal_fresnel(double cosine) {
    const double x = std::acos(std::clamp(cosine, -1.0, 1.0)) / (pi / 2);
    return std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
}

/// What metallic makes of a highlight's or a reflection's colour.
Vec3 metal_tint(const Vec3& pigment, double metallic, double cosine) {
    return Vec3(1) + metallic * (1 - metal_fresnel(cosine)) * (pigment - Vec3(1));
}

}  // namespace

// By Fresnel's equations.
double fresnel(double cosine, double n) {
    if (n == 1) return 0;
    const double g2 = n * n + cosine * cosine - 1;
    if (g2 <= 0) return 1;
    const double g = std::sqrt(g2);
    const double ratio = (g - cosine) / (g + cosine);
    const double tail = (cosine * (g + cosine) - 1) / (cosine * (g - cosine) + 1);
    return std::clamp(0.5 * ratio * ratio * (tail * tail + 1), 0.0, 1.0);
}

void for_textures_seen(const World& world, const Hit& hit, bool from_inside,
                       FunctionRef<void(double, const Texture&)> use) {
    const Handle<Texture>& inner = world.material(hit.primitive).inner;
    if (inner && from_inside)
        use(1, *inner);
    else
        world.for_textures(hit.primitive, hit.part, hit.position, use);
}

Shading shading_at(const World& world, const Ray& ray, const Hit& hit) {
    const Material& material = world.material(hit.primitive);
    const auto facing = [&](const Vec3& n) { return dot(n, ray.direction) > 0 ? -n : n; };
    Shading s;
    s.position = hit.position;
    s.view = ray.direction;
    s.true_normal = facing(hit.normal);
    s.tolerance = hit.tolerance;
    s.smooth_normal = facing(hit.smooth_normal);
    s.normal = s.smooth_normal;
    s.material = &material;
    s.both_sides = material.double_illuminate;
    return s;
}

Shading with_layer(const World& world, Shading s, const Layer& layer) {
    s.normal = layer.normal;
    s.finish = layer.finish;
    s.colour = layer.colour;
    s.opacity = world.opacity(layer.colour);
    return s;
}

Vec3 iridescence(const World& world, const Shading& s, const Vec3& direction) {
    const Irid& irid = s.finish->irid;
    if (!(irid.amount > 0)) return Vec3(1);
    double thickness = irid.thickness;
    if (irid.turbulence != 0)
        thickness *=
            1 + irid.turbulence * (2 * scalar_turbulence(s.position, {5, 0.5, 2},
                                                         world.pattern_scene().noise_generator) -
                                   1);
    const double phase =
        2 * pi * thickness * (std::abs(dot(s.normal, direction)) + std::abs(dot(s.normal, s.view)));
    const Vec3 turns = Vec3(phase) / world.rules.settings.irid_wavelength;
    return Vec3(1) + irid.amount * Vec3(std::cos(turns.x), std::cos(turns.y), std::cos(turns.z));
}

bool answers_light(const Shading& s) {
    return s.finish->microfacet.on ||
           ((s.finish->diffuse > 0 || s.finish->diffuse_back != 0) && s.colour.rgb != Vec3(0)) ||
           s.finish->phong > 0 || s.finish->specular > 0;
}

Vec3 own_radiance(const World& world, const Shading& s, bool glowing) {
    return s.colour.rgb * s.opacity *
           (s.finish->ambient * world.rules.settings.ambient_light +
            (glowing ? s.finish->emission : Vec3(0)));
}

namespace {

/// Whether a highlight's cosine to that power is above 10^-20, as far as is quickly told; far from
/// highlights it is not, and powers take long.
bool shows(double cosine, double power) { return cosine > 0 && (1 - cosine) * power < 46; }

}  // namespace

Vec3 response(const Shading& s, const Vec3& to_light, bool highlights, double grain) {
    const Finish& f = *s.finish;
    const double signed_cosine = dot(s.normal, to_light);
    const bool behind = signed_cosine < 1e-10;
    if (s.entering > 0)
        return Vec3(behind ? 0 : signed_cosine * (1 - fresnel(signed_cosine, s.entering)));
    if (behind && !s.both_sides && f.diffuse_back == 0) return Vec3(0);
    const double cosine = std::abs(signed_cosine);
    const double falloff =
        f.brilliance == 1 ? cosine : std::pow(std::fmax(cosine, 1e-10), f.brilliance);
    const bool back = behind && !s.both_sides;
    const double diffuse = s.only_shine ? 0 : back ? f.diffuse_back : std::fmax(f.diffuse, 0);
    Vec3 result = s.colour.rgb * (diffuse * falloff * s.opacity - f.crand * grain);
    if (back || !highlights || (f.phong <= 0 && f.specular <= 0)) return result;

    const Vec3 tint =
        f.metallic == 0 ? Vec3(1) : metal_tint(s.colour.rgb, f.metallic, signed_cosine);
    if (f.phong > 0) {
        const double alignment = dot(mirrored(s.view, s.normal), to_light);
        if (shows(alignment, f.phong_size))
            result += f.phong * std::pow(alignment, f.phong_size) * tint;
    }
    if (f.specular > 0) {
        const double alignment = dot(s.normal, unit(to_light - s.view));
        if (shows(alignment, 1 / f.roughness))
            result += f.specular * std::pow(alignment, 1 / f.roughness) * tint;
    }
    return result;
}

Vec3 reflectivity(const Shading& s, double ior_ratio) {
    const Reflection& r = s.finish->reflection;
    if (r.greatest == Vec3(0) && r.least == Vec3(0)) return Vec3(0);
    // Below 0 where a disturbed normal looks away: POV-Ray reflects more there than at grazing
    // angles.
    const double cosine = std::clamp(-dot(s.view, s.normal), -1.0, 1.0);
    const double grazing = !r.fresnel
                               ? (r.falloff == 1 ? 1 - cosine : std::pow(1 - cosine, r.falloff))
                           : cosine < 0 ? 1
                                        : fresnel(cosine, 1 / ior_ratio);
    const Vec3 amount = r.least + (r.greatest - r.least) * grazing;
    return r.metallic == 0 ? amount : amount * metal_tint(s.colour.rgb, r.metallic, cosine);
}
