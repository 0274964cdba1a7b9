// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/bsdf.h"

#include "base/colour.h"
#include "scattering/microfacet.h"
#include "scattering/mirror.h"
#include "scattering/phong.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Maximum exponent with which highlights are sampled, so that densities stay finite.
constexpr double sharpest = 1e6;
/// Surfaces without a diffuse term are sampled as if they had one: away from its centre, a
/// highlight falls off slower than its density.
constexpr double max_specular_probability = 0.9;

/// Draws a direction around an axis in proportion to a power of the cosine.
Vec3 draw_about(const Vec3& axis, double exponent, Vec2 u) {
    const auto [x, y] = perpendiculars(axis);
    const double cosine2 = std::pow(1 - u.x, 2 / (exponent + 1)), angle = 2 * pi * u.y;
    const double across = std::sqrt(1 - cosine2);
    return across * (std::cos(angle) * x + std::sin(angle) * y) + std::sqrt(cosine2) * axis;
}
double density_about(double cosine, double exponent) {
    return cosine > 0 ? (exponent + 1) / (2 * pi) * std::pow(cosine, exponent) : 0;
}

}  // namespace

Bsdf::Bsdf(const Shading& s, const ShadingRules& rules, Part part, double ior)
    : shading_(s), rules_(&rules), part_(part), ior_(ior) {
    const Finish& f = *s.finish;
    if (part == Part::entering || !(f.microfacet.on || f.phong > 0 || f.specular > 0)) return;
    diffuse_ =
        part == Part::highlights ? 0 : std::fmax(grey(s.colour.rgb) * f.diffuse * s.opacity, 0);
    if (f.microfacet.on) {
        const FacetLight light = facet_light(s);
        diffuse_ = light.base;
        for (const auto& [width, amount] : light.wide) add(Lobe::facets, width, amount);
    } else {
        // The integral of a highlight over all directions, relative to that of a white surface.
        const double size = std::clamp(f.phong_size, 0.0, sharpest),
                     exponent = f.roughness > 1 / sharpest ? 1 / f.roughness : sharpest;
        const double cosine = std::fmax(-dot(s.view, s.normal), 0);
        add(Lobe::about_mirrored, size, 2 * f.phong / (size + 1));
        add(Lobe::about_normal, exponent, 8 * f.specular * cosine / (exponent + 1));
    }
    for (const Lobe& lobe : highlight_lobes()) highlights_ += lobe.share;
    if (!(highlights_ > 0)) return;
    specular_probability_ =
        std::fmin(highlights_ / (highlights_ + diffuse_), max_specular_probability);
    for (std::size_t i = 0; i < count_; ++i) lobes_[i].share *= specular_probability_ / highlights_;
}

void Bsdf::add(Lobe::Kind kind, double extent, double light) {
    if (light > 0) lobes_[count_++] = {kind, extent, light};
}

BsdfLobes Bsdf::lobes() const {
    BsdfLobes result{diffuse_, {}, count_};
    const double cosine = std::fmax(-dot(shading_.view, shading_.normal), 1e-3);
    for (std::size_t i = 0; i < count_; ++i) {
        const auto& [kind, extent, share] = lobes_[i];
        const double light = share * highlights_ / specular_probability_;
        // The half vector turns half as far as the light, so its cosine changes by a quarter as
        // much.
        double sharpness = extent, peak = light * (extent + 1) / 2;
        if (kind == Lobe::about_normal) {
            sharpness = extent / 4;
            peak = light * (extent + 1) / (8 * cosine);
        } else if (kind == Lobe::facets) {
            sharpness = (1 - extent * extent) / (extent * extent);
            peak = light * mirrored_peak(shading_, extent);
        }
        result.highlights[i] = {mirrored(shading_.view, shading_.normal), peak, sharpness};
    }
    return result;
}

Vec3 Bsdf::sample_diffuse(Vec2 u) const {
    Vec3 normal = shading_.normal;
    if (shading_.both_sides) {
        if (u.x >= 0.5) normal = -normal;
        u.x = u.x < 0.5 ? 2 * u.x : 2 * u.x - 1;
    }
    return draw_about(normal, 1, u);
}

std::optional<Vec3> Bsdf::sample(const Lobe& lobe, Vec2 u) const {
    if (lobe.kind == Lobe::facets) return draw_mirrored(shading_, lobe.extent, u);
    if (lobe.kind == Lobe::about_mirrored)
        return draw_about(mirrored(shading_.view, shading_.normal), lobe.extent, u);
    const Vec3 half = draw_about(shading_.normal, lobe.extent, u);
    if (!(dot(half, shading_.view) < 0)) return {};
    return mirrored(shading_.view, half);
}

double Bsdf::pdf(const Lobe& lobe, const Vec3& direction) const {
    if (lobe.kind == Lobe::facets) return mirrored_density(shading_, lobe.extent, direction);
    if (lobe.kind == Lobe::about_mirrored)
        return density_about(dot(mirrored(shading_.view, shading_.normal), direction), lobe.extent);
    const Vec3 half = unit(direction - shading_.view);
    const double between = dot(half, direction);
    if (!(between > 0)) return 0;
    return density_about(dot(half, shading_.normal), lobe.extent) / (4 * between);
}

std::optional<Vec3> Bsdf::sample(Vec2 u) const {
    for (const Lobe& lobe : highlight_lobes()) {
        if (u.x < lobe.share) return sample(lobe, {u.x / lobe.share, u.y});
        u.x -= lobe.share;
    }
    return sample_diffuse({std::fmin(u.x / (1 - specular_probability_), 1 - 0x1p-53), u.y});
}

double Bsdf::pdf(const Vec3& direction) const {
    const double cosine = dot(shading_.normal, direction);
    const double diffuse =
        shading_.both_sides ? std::abs(cosine) / (2 * pi) : std::fmax(cosine, 0) / pi;
    double sum = (1 - specular_probability_) * diffuse;
    for (const Lobe& lobe : highlight_lobes()) sum += lobe.share * pdf(lobe, direction);
    return sum;
}

bool Bsdf::answers_light() const {
    const Finish& f = *shading_.finish;
    return part_ == Part::entering || f.microfacet.on ||
           ((f.diffuse > 0 || f.diffuse_back != 0) && shading_.colour.rgb != Vec3(0)) ||
           f.phong > 0 || f.specular > 0;
}

Vec3 Bsdf::film(const Vec3& to_light) const {
    return part_ == Part::entering ? Vec3(1) : iridescence(shading_, *rules_, to_light);
}

Vec3 Bsdf::evaluate_without_film(const Vec3& to_light, const BsdfTerms& terms, double grain) const {
    if (part_ == Part::entering) {
        const double cosine = dot(shading_.normal, to_light);
        return Vec3(cosine < 1e-10 ? 0 : cosine * (1 - fresnel(cosine, ior_)));
    }
    if (shading_.finish->microfacet.on)
        return terms.facets == FacetLobes::none
                   ? facet_base_response(shading_, to_light)
                   : facet_response(shading_, to_light, terms.facets == FacetLobes::wide);
    return finish_response(shading_, to_light,
                           {part_ != Part::highlights, terms.highlights, terms.brilliance}, grain);
}

}  // namespace candelabra
