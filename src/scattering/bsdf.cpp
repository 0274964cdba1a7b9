// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/bsdf.h"

#include "base/circle.h"
#include "base/colour.h"
#include "base/cosine_direction.h"
#include "base/elementary.h"
#include "base/random.h"
#include "scattering/mirror.h"
#include "scattering/phong.h"
#include "scattering/real_surface.h"

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
    const double cosine2 = math::pow(1 - u.x, 2 / (exponent + 1)), angle = 2 * pi * u.y;
    const double across = std::sqrt(1 - cosine2);
    return across * on_circle(angle, x, y) + std::sqrt(cosine2) * axis;
}
double density_about(double cosine, double exponent) {
    return cosine > 0 ? (exponent + 1) / (2 * pi) * math::pow(cosine, exponent) : 0;
}

}  // namespace

Bsdf::Bsdf(const Shading& s, const ShadingRules& rules, Part part, double ior)
    : shading_(s), rules_(&rules), part_(part), ior_(ior) {
    const Finish& f = *s.finish;
    if (part == Part::entering || !(f.microfacet.on || f.phong > 0 || f.specular > 0)) return;
    diffuse_ =
        part == Part::highlights ? 0 : std::fmax(grey(s.colour.rgb) * f.diffuse * s.opacity, 0);
    if (f.microfacet.on) {
        facets_.emplace(s);
        const FacetLight light = facets_->light();
        diffuse_ = light.diffuse;
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
        Highlight& h = result.highlights[i];
        switch (kind) {
            case Lobe::about_mirrored:
                h = {mirrored(shading_.view, shading_.normal), light * (extent + 1) / 2, extent};
                break;
            case Lobe::about_normal:
                // Near the axis the power of a cosine falls off by half of its exponent times the
                // squared sine, and a lobe by twice its sharpness times that.
                h = {shading_.normal, light * (extent + 1) / (8 * cosine), extent / 4,
                     -shading_.view};
                break;
            case Lobe::facets:
                const auto [normal, viewer] = facets_->seen_facets();
                h = {normal, light * facets_->mirrored_peak(extent),
                     (1 - extent * extent) / (extent * extent), viewer};
                break;
        }
    }
    return result;
}

/// Fraction of the directions of the diffuse part that are drawn behind the surface.
double Bsdf::share_behind() const {
    if (part_ == Part::entering || !answers_behind(shading_)) return 0;
    if (shading_.both_sides) return 0.5;
    const Finish& f = *shading_.finish;
    const double back = std::abs(f.diffuse_back);
    // A highlight falls off slower than its density, so that it needs directions in front as well.
    const double front = std::fmax(f.diffuse, highlights_ > 0 ? back / 4 : 0);
    return back / (std::fmax(front, 0) + back);
}

/// Whether light from the direction is scattered.
bool Bsdf::counts(const Vec3& direction) const {
    const LitSide side = side_of(shading_, direction);
    return side == LitSide::front || (side == LitSide::behind && share_behind() > 0);
}

std::optional<Vec3> Bsdf::sample_diffuse(Vec2 u) const {
    if (facets_) return facets_->draw_diffuse(u);
    const double front = 1 - share_behind();
    const bool behind = u.x >= front;
    u.x = behind ? (u.x - front) / (1 - front) : u.x / front;
    const Vec3 direction = cosine_direction(behind ? -shading_.normal : shading_.normal,
                                            {std::fmin(u.x, below_1), u.y});
    return counts(direction) ? std::optional(direction) : std::nullopt;
}

double Bsdf::diffuse_pdf(const Vec3& direction) const {
    if (facets_) return facets_->diffuse_density(direction);
    if (!counts(direction)) return 0;
    const double cosine = dot(shading_.normal, direction), behind = share_behind();
    return std::abs(cosine) * (cosine < 0 ? behind : 1 - behind) / pi;
}

Rgb Bsdf::diffuse_albedo() const {
    const Finish& f = *shading_.finish;
    const double amount =
        facets_ ? facets_->base_albedo() : std::fmax(f.diffuse, 0) + std::abs(f.diffuse_back);
    return shading_.colour.rgb * (shading_.opacity * amount);
}

std::optional<Vec3> Bsdf::sample(const Lobe& lobe, Vec2 u) const {
    if (lobe.kind == Lobe::facets) return facets_->draw_mirrored(lobe.extent, u);
    if (lobe.kind == Lobe::about_mirrored)
        return draw_about(mirrored(shading_.view, shading_.normal), lobe.extent, u);
    const Vec3 half = draw_about(shading_.normal, lobe.extent, u);
    if (!(dot(half, shading_.view) < 0)) return {};
    return mirrored(shading_.view, half);
}

double Bsdf::pdf(const Lobe& lobe, const Vec3& direction) const {
    if (lobe.kind == Lobe::facets) return facets_->mirrored_density(lobe.extent, direction);
    if (lobe.kind == Lobe::about_mirrored)
        return density_about(dot(mirrored(shading_.view, shading_.normal), direction), lobe.extent);
    const Vec3 half = unit(direction - shading_.view);
    const double between = dot(half, direction);
    if (!(between > 0)) return 0;
    return density_about(dot(half, shading_.normal), lobe.extent) / (4 * between);
}

std::optional<Vec3> Bsdf::sample(Vec2 u) const {
    for (const Lobe& lobe : highlight_lobes()) {
        if (u.x < lobe.share) {
            const auto drawn = sample(lobe, {u.x / lobe.share, u.y});
            return drawn && (facets_ || counts(*drawn)) ? drawn : std::nullopt;
        }
        u.x -= lobe.share;
    }
    return sample_diffuse({std::fmin(u.x / (1 - specular_probability_), below_1), u.y});
}

double Bsdf::pdf(const Vec3& direction) const {
    double sum = (1 - specular_probability_) * diffuse_pdf(direction);
    if (count_ == 0 || (!facets_ && !counts(direction))) return sum;
    for (const Lobe& lobe : highlight_lobes()) sum += lobe.share * pdf(lobe, direction);
    return sum;
}

bool Bsdf::answers_light() const {
    const Finish& f = *shading_.finish;
    return part_ == Part::entering || f.microfacet.on ||
           ((f.diffuse > 0 || f.diffuse_back != 0) && shading_.colour.rgb != Rgb(0)) ||
           f.phong > 0 || f.specular > 0;
}

Rgb Bsdf::film(const Vec3& to_light) const {
    return part_ == Part::entering ? Rgb(1) : iridescence(shading_, *rules_, to_light);
}

Rgb Bsdf::evaluate_without_film(const Vec3& to_light, const BsdfTerms& terms, double grain) const {
    if (facets_)
        return terms.facets == FacetLobes::none
                   ? facets_->base_response(to_light)
                   : facets_->response(to_light, terms.facets == FacetLobes::wide);
    if (!terms.through_surface && side_of(shading_, to_light) == LitSide::none) return Rgb(0);
    if (part_ == Part::entering) {
        const double cosine = dot(shading_.normal, to_light);
        return Rgb(cosine < 1e-10 ? 0 : cosine * (1 - fresnel(cosine, ior_)));
    }
    return finish_response(shading_, to_light,
                           {part_ != Part::highlights, terms.highlights, terms.brilliance}, grain);
}

}  // namespace candelabra
