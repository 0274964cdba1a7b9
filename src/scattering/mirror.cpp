// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/mirror.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

/// POV-Ray's fit of the metallic Fresnel curve: 0 at normal incidence, 1 at grazing angles, and
/// less again beyond them, where a perturbed normal faces away.
double metal_fresnel(double cosine) {
    const double x = math::acos(std::clamp(cosine, -1.0, 1.0)) / (std::numbers::pi / 2);
    return std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
}

}  // namespace

Rgb metal_tint(const Rgb& pigment, double metallic, double cosine) {
    return Rgb(1) + metallic * (1 - metal_fresnel(cosine)) * (pigment - Rgb(1));
}

// Fresnel's equations.
double fresnel(double cosine, double n) {
    if (n == 1) return 0;
    const double g2 = n * n + cosine * cosine - 1;
    if (g2 <= 0) return 1;
    const double g = std::sqrt(g2);
    const double ratio = (g - cosine) / (g + cosine);
    const double tail = (cosine * (g + cosine) - 1) / (cosine * (g - cosine) + 1);
    return std::clamp(0.5 * ratio * ratio * (tail * tail + 1), 0.0, 1.0);
}

Rgb reflectivity(const Shading& s, double ior_ratio) {
    const Reflection& r = s.finish->reflection;
    if (r.greatest == Rgb(0) && r.least == Rgb(0)) return Rgb(0);
    // Below 0 where a perturbed normal faces away: POV-Ray reflects more there than at grazing
    // angles.
    const double cosine = std::clamp(-dot(s.view, s.normal), -1.0, 1.0);
    const double grazing = !r.fresnel
                               ? (r.falloff == 1 ? 1 - cosine : math::pow(1 - cosine, r.falloff))
                           : cosine < 0 ? 1
                                        : fresnel(cosine, 1 / ior_ratio);
    const double shown = s.finish->use_alpha ? s.opacity : 1;
    const Rgb amount = shown * (r.least + (r.greatest - r.least) * grazing);
    return r.metallic == 0 ? amount : amount * metal_tint(s.colour.rgb, r.metallic, cosine);
}

double greatest_reflectivity(const Reflection& reflection, const Rgb& amount) {
    return reflection.fresnel
               ? max_component(amount)
               : std::max(max_component(reflection.least), max_component(reflection.greatest));
}

Vec3 reflected_direction(const Shading& s) {
    Vec3 direction = mirrored(s.view, s.normal);
    // Where the bump faces away from the viewer, POV-Ray ignores it. A ray that the smooth normal
    // alone reflects into the surface goes there.
    if (dot(direction, s.smooth_normal) < 0)
        direction = mirrored(dot(direction, s.normal) < 0 ? s.view : direction, s.smooth_normal);
    return unit(direction);
}

Vec3 refracted_direction(const Shading& s, double ior_ratio) {
    // A perturbed normal that faces away from the viewer is flipped.
    const Vec3 normal = dot(s.view, s.normal) > 0 ? -s.normal : s.normal;
    const double cosine = -dot(s.view, normal);
    const double behind = std::sqrt(1 - ior_ratio * ior_ratio * (1 - cosine * cosine));
    return unit(ior_ratio * s.view + (ior_ratio * cosine - behind) * normal);
}

bool reflects_totally(const Shading& s, double ior_ratio) {
    const double cosine = -dot(s.view, s.normal);
    return ior_ratio * ior_ratio * (1 - cosine * cosine) > 1;
}

}  // namespace candelabra
