// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/microfacet.h"

#include "base/colour.h"
#include "base/cosine_direction.h"
#include "scattering/ggx.h"
#include "scattering/real_surface.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Reflectance of a clear coat at normal incidence: that of an index of refraction of 1.5.
constexpr double coat_facing = 0.04;
constexpr double max_specular = 0.08;

/// Width from which on luminaires are sampled for a lobe as well. In narrower lobes most samples of
/// small lamps miss, and scattered rays alone are less noisy (tests/bench/README.md).
constexpr double narrow = 0.008;

/// Cosines of light, viewer and facet normal for one surface; all are above 0.
struct FacetGeometry {
    double light, viewer, facet, between;  ///< `between`: light and facet normal
};

/// Reflected radiance of light of colour 1, without the Fresnel factor.
double reflected(double width, const FacetGeometry& g) {
    return facet_density(width, g.facet) * unhidden(width, g.light) * unhidden(width, g.viewer) *
           pi * g.light;
}

/// Colour of light that metallic facets reflect more than once, for facets that reflect the mean
/// fraction `escaping` of light at once.
Rgb colour_of_further(const Rgb& facing, double escaping) {
    const Rgb within = clamp(facing, Rgb(0), Rgb(1));
    const Rgb mean = within + (Rgb(1) - within) / 21.0;  // of Schlick's approximation
    return mean * mean * escaping / (Rgb(1) - mean * (1 - escaping));
}

/// Nodes and weights of Gauss's rule for the interval from 0 to 1.
struct Node {
    double at, weight;
};
constexpr std::array<Node, 6> nodes = {{{0.033765242898423975, 0.085662246189585178},
                                        {0.169395306766867648, 0.180380786524069303},
                                        {0.380690406958401506, 0.233956967286345524},
                                        {0.619309593041598494, 0.233956967286345524},
                                        {0.830604693233132352, 0.180380786524069303},
                                        {0.966234757101576025, 0.085662246189585178}}};

}  // namespace

Microfacets::Microfacets(const Shading& s)
    : material_(s.finish->microfacet),
      colour_(s.colour.rgb),
      opacity_(s.opacity),
      dielectric_(max_specular * material_.specular),
      metal_(material_.metallic * opacity_),
      facing_((1 - material_.metallic) * Rgb(dielectric_) + metal_ * colour_),
      grazing_(1 - material_.metallic * (1 - opacity_)),
      view_(s.view),
      geometric_normal_(s.geometric_normal),
      normal_(fitted_normal(s)),
      viewer_(std::max(-dot(normal_, view_), 1e-4)),
      bent_(normal_ != geometric_normal_),
      viewer_left_(left_at(viewer_)) {
    const Left mean = mean_left();
    const auto inverse = [](double x) { return x > 0 ? 1 / x : 0; };
    base_ = colour_ * (base_albedo() * opacity_);
    per_base_ = inverse(mean.base);
    further_ = colour_of_further(colour_, mean_facet_albedo(material_.roughness).all) *
               (metal_ * viewer_left_.further);
    per_further_ = inverse(mean.further);
}

Rgb Microfacets::mirror(double cosine) const {
    return facing_ + (Rgb(grazing_) - facing_) * grazing_share(cosine);
}

double Microfacets::coat(double cosine) const {
    return material_.coat * schlick(coat_facing, cosine);
}

Microfacets::Left Microfacets::left_of(const FacetAlbedo& own, const FacetAlbedo& coat) const {
    const double by_coat = material_.coat * coat.schlick(coat_facing);
    return {by_coat, (1 - by_coat) * (1 - own.schlick(dielectric_)), (1 - by_coat) * (1 - own.all)};
}

Microfacets::Left Microfacets::left_at(double cosine) const {
    return left_of(
        facet_albedo(material_.roughness, cosine),
        material_.coat > 0 ? facet_albedo(material_.coat_roughness, cosine) : FacetAlbedo());
}

/// The mean over all directions, weighted by the cosine.
Microfacets::Left Microfacets::mean_left() const {
    if (!(material_.coat > 0)) return left_of(mean_facet_albedo(material_.roughness), {});
    Left sum{0, 0, 0};
    for (const auto& [cosine, weight] : nodes) {
        const Left there = left_at(cosine);
        sum.base += 2 * cosine * weight * there.base;
        sum.further += 2 * cosine * weight * there.further;
    }
    return sum;
}

// Both are the same for light and viewer exchanged, and reflect all that the viewer's direction
// leaves for them if they are white.
Rgb Microfacets::base_at(const Left& left) const { return base_ * (left.base * per_base_); }
Rgb Microfacets::further_at(const Left& left) const {
    return further_ * (left.further * per_further_);
}

/// The sum of use(direction) for the light's direction and for the one that the real surface
/// mirrors to it.
template <class Use>
auto Microfacets::folded(const Vec3& to_light, const Use& use) const {
    using Value = decltype(use(to_light));
    if (!bent_) return use(to_light);
    if (!(dot(to_light, geometric_normal_) > 0)) return Value(0);
    return use(to_light) + use(mirrored(to_light, geometric_normal_));
}

Rgb Microfacets::base_response(const Vec3& to_light) const {
    return folded(to_light, [&](const Vec3& direction) {
        const double light = dot(normal_, direction);
        return light <= 1e-10 ? Rgb(0) : base_at(left_at(light)) * light;
    });
}

Rgb Microfacets::response(const Vec3& to_light, bool wide_only) const {
    return folded(to_light, [&](const Vec3& direction) { return at(direction, wide_only); });
}

Rgb Microfacets::at(const Vec3& to_light, bool wide_only) const {
    FacetGeometry g;
    g.light = dot(normal_, to_light);
    if (g.light <= 1e-10) return Rgb(0);
    g.viewer = viewer_;
    const Vec3 facet = unit(to_light - view_);
    g.facet = std::clamp(dot(normal_, facet), 0.0, 1.0);
    g.between = std::clamp(dot(to_light, facet), 0.0, 1.0);
    const auto counts = [&](double width) { return !wide_only || width >= narrow; };
    const Left left = left_at(g.light);
    Rgb sum = (base_at(left) + further_at(left)) * g.light;
    // What the coat leaves of a mirrored direction is the same for light and viewer; elsewhere the
    // lesser of both counts, which makes no light.
    if (const double w = facet_width(material_.roughness); counts(w))
        sum += mirror(g.between) * (reflected(w, g) * (1 - std::max(left.coat, viewer_left_.coat)));
    if (const double w = facet_width(material_.coat_roughness); material_.coat > 0 && counts(w))
        sum += Rgb(coat(g.between) * reflected(w, g));
    return sum;
}

FacetLight Microfacets::light() const {
    const auto lobe = [](double roughness, double amount) {
        const double w = facet_width(roughness);
        return FacetLight::Lobe{w, w >= narrow ? amount : 0};
    };
    return {grey(base_) + grey(further_),
            {lobe(material_.roughness, mirror_albedo(grey(facing_))),
             lobe(material_.coat_roughness, viewer_left_.coat)}};
}

/// Fraction of uniform light that the facets below the coat reflect at once.
double Microfacets::mirror_albedo(double facing) const {
    const FacetAlbedo own = facet_albedo(material_.roughness, viewer_);
    return std::max(facing * (own.all - own.grazing) + grazing_ * own.grazing, 0.0) *
           (1 - viewer_left_.coat);
}

double Microfacets::passing() const {
    return base_albedo() + material_.metallic * (1 - viewer_left_.coat);
}

Rgb Microfacets::facets_albedo() const {
    const FacetAlbedo own = facet_albedo(material_.roughness, viewer_);
    const Rgb at_once = facing_ * (own.all - own.grazing) + Rgb(grazing_ * own.grazing);
    return Rgb(viewer_left_.coat) + (1 - viewer_left_.coat) * at_once + further_;
}

/// The same as draw_mirrored(), before the real surface mirrors what would lead into it.
std::optional<Vec3> Microfacets::draw_raw(double width, Vec2 place) const {
    const auto [x, y] = perpendiculars(normal_);
    const Vec3 viewer(-dot(x, view_), -dot(y, view_), viewer_);
    const Vec3 facet = visible_facet(viewer, width, place);
    const double between = dot(viewer, facet);
    const Vec3 light = 2 * between * facet - viewer;
    if (light.z <= 0 || between <= 0) return std::nullopt;
    return unit(light.x * x + light.y * y + light.z * normal_);
}

std::optional<Vec3> Microfacets::draw_mirrored(double width, Vec2 place) const {
    const auto raw = draw_raw(width, place);
    return raw ? std::optional(lifted(*raw, geometric_normal_)) : std::nullopt;
}

double Microfacets::mirrored_density(double width, const Vec3& to_light) const {
    return folded(to_light, [&](const Vec3& direction) {
        if (dot(normal_, direction) <= 0) return 0.0;
        const double cosine = std::clamp(dot(normal_, unit(direction - view_)), 0.0, 1.0);
        return facet_density(width, cosine) * unhidden(width, viewer_) / 2;
    });
}

Vec3 Microfacets::draw_diffuse(Vec2 place) const {
    return lifted(cosine_direction(normal_, place), geometric_normal_);
}

double Microfacets::diffuse_density(const Vec3& to_light) const {
    return folded(to_light, [&](const Vec3& direction) {
        return std::max(dot(normal_, direction), 0.0) / pi;
    });
}

double Microfacets::mirrored_peak(double width) const {
    return reflected(width, {viewer_, viewer_, 1, viewer_});
}

Microfacets::SeenFacets Microfacets::seen_facets() const {
    if (dot(mirrored(view_, normal_), geometric_normal_) > 0) return {normal_, -view_};
    return {mirrored(normal_, geometric_normal_), -mirrored(view_, geometric_normal_)};
}

std::optional<Scattered> Microfacets::scatter(double choice, Vec2 place) const {
    const double by_coat = viewer_left_.coat, by_mirror = mirror_albedo(max_component(facing_)),
                 by_further = std::max(max_component(further_), 0.0),
                 all = by_coat + by_mirror + by_further;
    if (!(all > 0)) return std::nullopt;
    if (by_further > 0 && choice * all >= by_coat + by_mirror) {
        const Vec3 raw = cosine_direction(normal_, place);
        return Scattered{lifted(raw, geometric_normal_),
                         further_at(left_at(dot(raw, normal_))) * (all / by_further), false};
    }
    const bool on_coat = choice * all < by_coat;
    const double w = facet_width(on_coat ? material_.coat_roughness : material_.roughness);
    const auto raw = draw_raw(w, place);
    if (!raw) return std::nullopt;
    const double between = dot(*raw, unit(*raw - view_));
    // With visible normals, the weight is the Fresnel factor times the masking of the light.
    const double up = std::max(dot(*raw, normal_), 0.0), unseen = 2 * up * unhidden(w, up);
    const Rgb share =
        on_coat
            ? Rgb(coat(between) / by_coat)
            : mirror(between) * ((1 - std::max(viewer_left_.coat, left_at(up).coat)) / by_mirror);
    return Scattered{lifted(*raw, geometric_normal_), share * (unseen * all), w < narrow};
}

}  // namespace candelabra
