// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scattering.h"

#include "base/colour.h"
#include "render/microfacet.h"

#include <algorithm>
#include <numbers>

namespace {

using std::numbers::pi;

/// Sharper highlights are drawn as these, so that densities stay numbers.
constexpr double sharpest = 1e6;
/// Surfaces without a diffuse part are drawn from as if they had some: away from its middle, a
/// highlight falls off slower than its density.
constexpr double most_gloss = 0.9;

/// A direction about an axis, in proportion to a power of the cosine.
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

Scattering::Scattering(const Shading& s) : s_(s) {
    const Finish& f = *s.finish;
    if (s.entering > 0 || !(f.microfacet.on || f.phong > 0 || f.specular > 0)) return;
    dull_ = s.only_shine ? 0 : std::fmax(grey(s.colour.rgb) * f.diffuse * s.opacity, 0);
    if (f.microfacet.on) {
        const FacetLight light = facet_light(s);
        dull_ = light.base;
        for (const auto& [width, amount] : light.wide) add(Lobe::facets, width, amount);
    } else {
        // A highlight's integral over all directions, as a share of that of a white surface.
        const double size = std::clamp(f.phong_size, 0.0, sharpest),
                     exponent = f.roughness > 1 / sharpest ? 1 / f.roughness : sharpest;
        const double cosine = std::fmax(-dot(s.view, s.normal), 0);
        add(Lobe::about_mirrored, size, 2 * f.phong / (size + 1));
        add(Lobe::about_normal, exponent, 8 * f.specular * cosine / (exponent + 1));
    }
    for (const Lobe& lobe : lobes()) highlights_ += lobe.share;
    if (!(highlights_ > 0)) return;
    gloss_ = std::fmin(highlights_ / (highlights_ + dull_), most_gloss);
    for (std::size_t i = 0; i < count_; ++i) lobes_[i].share *= gloss_ / highlights_;
}

void Scattering::add(Lobe::Kind kind, double extent, double light) {
    if (light > 0) lobes_[count_++] = {kind, extent, light};
}

Gloss Scattering::answers() const {
    Gloss result{dull_, {}, count_};
    const double cosine = std::fmax(-dot(s_.view, s_.normal), 1e-3);
    for (std::size_t i = 0; i < count_; ++i) {
        const auto& [kind, extent, share] = lobes_[i];
        const double light = share * highlights_ / gloss_;
        // The half vector turns half as far as the light, and so its cosine changes by a quarter.
        double sharpness = extent, peak = light * (extent + 1) / 2;
        if (kind == Lobe::about_normal) {
            sharpness = extent / 4;
            peak = light * (extent + 1) / (8 * cosine);
        } else if (kind == Lobe::facets) {
            sharpness = (1 - extent * extent) / (extent * extent);
            peak = light * mirrored_peak(s_, extent);
        }
        result.highlights[i] = {mirrored(s_.view, s_.normal), peak, sharpness};
    }
    return result;
}

Vec3 Scattering::draw_diffuse(Vec2 u) const {
    Vec3 normal = s_.normal;
    if (s_.both_sides) {
        if (u.x >= 0.5) normal = -normal;
        u.x = u.x < 0.5 ? 2 * u.x : 2 * u.x - 1;
    }
    return draw_about(normal, 1, u);
}

std::optional<Vec3> Scattering::draw(const Lobe& lobe, Vec2 u) const {
    if (lobe.kind == Lobe::facets) return draw_mirrored(s_, lobe.extent, u);
    if (lobe.kind == Lobe::about_mirrored)
        return draw_about(mirrored(s_.view, s_.normal), lobe.extent, u);
    const Vec3 half = draw_about(s_.normal, lobe.extent, u);
    if (!(dot(half, s_.view) < 0)) return {};
    return mirrored(s_.view, half);
}

double Scattering::density(const Lobe& lobe, const Vec3& direction) const {
    if (lobe.kind == Lobe::facets) return mirrored_density(s_, lobe.extent, direction);
    if (lobe.kind == Lobe::about_mirrored)
        return density_about(dot(mirrored(s_.view, s_.normal), direction), lobe.extent);
    const Vec3 half = unit(direction - s_.view);
    const double between = dot(half, direction);
    if (!(between > 0)) return 0;
    return density_about(dot(half, s_.normal), lobe.extent) / (4 * between);
}

std::optional<Vec3> Scattering::draw(Vec2 u) const {
    for (const Lobe& lobe : lobes()) {
        if (u.x < lobe.share) return draw(lobe, {u.x / lobe.share, u.y});
        u.x -= lobe.share;
    }
    return draw_diffuse({std::fmin(u.x / (1 - gloss_), 1 - 0x1p-53), u.y});
}

double Scattering::density(const Vec3& direction) const {
    const double cosine = dot(s_.normal, direction);
    const double diffuse = s_.both_sides ? std::abs(cosine) / (2 * pi) : std::fmax(cosine, 0) / pi;
    double sum = (1 - gloss_) * diffuse;
    for (const Lobe& lobe : lobes()) sum += lobe.share * density(lobe, direction);
    return sum;
}
