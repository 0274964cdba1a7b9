// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/phong.h"

#include "base/elementary.h"
#include "scattering/mirror.h"

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

/// Quick test whether a power of a highlight's cosine exceeds 10^-20: away from highlights it does
/// not, and powers are expensive.
bool shows(double cosine, double power) { return cosine > 0 && (1 - cosine) * power < 46; }

}  // namespace

Rgb own_radiance(const Shading& s, const ShadingRules& rules, double emission) {
    const Rgb emitted = emission != 0 ? emission * s.finish->emission : Rgb(0);
    return s.colour.rgb * s.opacity * (s.finish->ambient * rules.ambient_light + emitted);
}

Rgb iridescence(const Shading& s, const ShadingRules& rules, const Vec3& direction) {
    const Irid& irid = s.finish->irid;
    if (!(irid.amount > 0)) return Rgb(1);
    double thickness = irid.thickness;
    if (irid.turbulence != 0)
        thickness *=
            1 + irid.turbulence *
                    (2 * scalar_turbulence(s.position, {5, 0.5, 2}, rules.noise_generator) - 1);
    const double phase = 2 * std::numbers::pi * thickness *
                         (std::abs(dot(s.normal, direction)) + std::abs(dot(s.normal, s.view)));
    const Rgb turns = Rgb(phase) / rules.irid_wavelength;
    return Rgb(1) + irid.amount * Rgb(math::cos(turns.r), math::cos(turns.g), math::cos(turns.b));
}

Rgb finish_response(const Shading& s, const Vec3& to_light, FinishTerms terms, double grain) {
    const Finish& f = *s.finish;
    const double signed_cosine = dot(s.normal, to_light);
    const bool behind = signed_cosine < 1e-10;
    if (behind && !s.both_sides && f.diffuse_back == 0) return Rgb(0);
    const double cosine = std::abs(signed_cosine);
    const double falloff = f.brilliance == 1 || !terms.brilliance
                               ? cosine
                               : math::pow(std::fmax(cosine, 1e-10), f.brilliance);
    const bool back = behind && !s.both_sides;
    const double diffuse = !terms.diffuse ? 0 : back ? f.diffuse_back : std::fmax(f.diffuse, 0);
    const double crand = terms.diffuse ? f.crand * grain : 0;
    Rgb result = s.colour.rgb * (diffuse * falloff * s.opacity - crand);
    if (back || !terms.highlights || (f.phong <= 0 && f.specular <= 0)) return result;

    const Rgb metal =
        f.metallic == 0 ? Rgb(1) : metal_tint(s.colour.rgb, f.metallic, signed_cosine);
    const Rgb tint = f.use_alpha ? s.opacity * metal : metal;
    if (f.phong > 0) {
        const double alignment = dot(mirrored(s.view, s.normal), to_light);
        if (shows(alignment, f.phong_size))
            result += f.phong * math::pow(alignment, f.phong_size) * tint;
    }
    if (f.specular > 0) {
        const double alignment = dot(s.normal, unit(to_light - s.view));
        if (shows(alignment, 1 / f.roughness))
            result += f.specular * math::pow(alignment, 1 / f.roughness) * tint;
    }
    return result;
}

}  // namespace candelabra
