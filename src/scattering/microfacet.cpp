// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/microfacet.h"

#include "base/colour.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Reflectance of a clear coat at normal incidence: that of an index of refraction of 1.5.
constexpr double coat_facing = 0.04;
constexpr double max_specular = 0.08;

/// Width from which on lobes are left to the sampling of luminaires.
constexpr double narrow = 0.1;

double width(double roughness) { return std::max(roughness * roughness, 1e-3); }

double grazing(double cosine) {
    const double x = std::clamp(1 - cosine, 0.0, 1.0);
    return x * x * x * x * x;
}

/// Schlick's approximation of Fresnel's equations.
double schlick(double facing, double cosine) { return facing + (1 - facing) * grazing(cosine); }

/// GGX density of facets at this cosine between their normal and the surface's.
double density(double width, double cosine) {
    const double d = cosine * cosine * (width * width - 1) + 1;
    return width * width / (pi * d * d);
}

/// Smith's masking of facets in a direction, over twice its cosine.
double unhidden(double width, double cosine) {
    return 1 / (cosine + std::sqrt(width * width + (1 - width * width) * cosine * cosine));
}

/// Cosines of light, viewer and facet normal for one surface; all are above 0.
struct FacetGeometry {
    double light, viewer, facet, between;  ///< `between`: light and facet normal
};

/// Reflected radiance of light of colour 1, without the Fresnel factor.
double reflected(double width, const FacetGeometry& g) {
    return density(width, g.facet) * unhidden(width, g.light) * unhidden(width, g.viewer) * pi *
           g.light;
}

double viewer_cosine(const Shading& s) { return std::max(-dot(s.normal, s.view), 1e-4); }

/// The layers of one surface.
struct Layers {
    explicit Layers(const Shading& s)
        : material(s.finish->microfacet),
          base(s.colour.rgb),
          facing((1 - material.metallic) * Vec3(max_specular * material.specular) +
                 material.metallic * base) {}

    Vec3 mirror(double cosine) const { return facing + (Vec3(1) - facing) * grazing(cosine); }
    double coat(double cosine) const { return material.coat * schlick(coat_facing, cosine); }

    const Microfacet& material;
    Vec3 base;
    Vec3 facing;  ///< reflectance at normal incidence
};

/// Draws the normal of a facet in proportion to its visible area: Heitz, "Sampling the GGX
/// Distribution of Visible Normals", 2018. In a space whose z axis is the surface's normal.
Vec3 seen_facet(const Vec3& viewer, double width, Vec2 place) {
    const Vec3 stretched = unit(Vec3(width * viewer.x, width * viewer.y, viewer.z));
    const double flat = stretched.x * stretched.x + stretched.y * stretched.y;
    const Vec3 side =
        flat > 0 ? Vec3(-stretched.y, stretched.x, 0) / std::sqrt(flat) : Vec3(1, 0, 0);
    const Vec3 above = cross(stretched, side);
    const double radius = std::sqrt(place.x), angle = 2 * pi * place.y;
    const double a = radius * std::cos(angle);
    const double share = 0.5 * (1 + stretched.z);
    const double b =
        (1 - share) * std::sqrt(std::max(0.0, 1 - a * a)) + share * radius * std::sin(angle);
    const Vec3 n = a * side + b * above + std::sqrt(std::max(0.0, 1 - a * a - b * b)) * stretched;
    return unit(Vec3(width * n.x, width * n.y, std::max(1e-9, n.z)));
}

/// Light scattered by the base without a coat, below facets that reflect the fraction `inner`.
Vec3 base_response(const Shading& s, const Layers& layers, double inner, double light) {
    return layers.base * ((1 - layers.material.metallic) * (1 - inner) * light * s.opacity);
}

double inner_share(const Microfacet& m, double between) {
    return schlick(max_specular * m.specular, between);
}

}  // namespace

Vec3 facet_base_response(const Shading& s, const Vec3& to_light) {
    const double light = dot(s.normal, to_light);
    if (light <= 1e-10) return Vec3(0);
    const double between = std::clamp(dot(to_light, unit(to_light - s.view)), 0.0, 1.0);
    const Layers layers(s);
    return base_response(s, layers, inner_share(layers.material, between), light) *
           (1 - layers.coat(between));
}

Vec3 facet_response(const Shading& s, const Vec3& to_light, bool wide_only) {
    FacetGeometry g;
    g.light = dot(s.normal, to_light);
    if (g.light <= 1e-10) return Vec3(0);
    g.viewer = viewer_cosine(s);
    const Vec3 facet = unit(to_light - s.view);
    g.facet = std::clamp(dot(s.normal, facet), 0.0, 1.0);
    g.between = std::clamp(dot(to_light, facet), 0.0, 1.0);
    const Layers layers(s);
    const Microfacet& m = layers.material;
    const auto counts = [&](double width) { return !wide_only || width >= narrow; };
    Vec3 sum = base_response(s, layers, inner_share(m, g.between), g.light);
    if (const double w = width(m.roughness); counts(w))
        sum += layers.mirror(g.between) * reflected(w, g);
    const double coat = layers.coat(g.between);
    if (coat == 0) return sum;
    sum *= 1 - coat;
    if (const double w = width(m.coat_roughness); counts(w)) sum += Vec3(coat * reflected(w, g));
    return sum;
}

FacetLight facet_light(const Shading& s) {
    const Layers layers(s);
    const Microfacet& m = layers.material;
    const double cosine = viewer_cosine(s), coat = layers.coat(cosine);
    const auto lobe = [](double roughness, double amount) {
        const double w = width(roughness);
        return FacetLight::Lobe{w, w >= narrow ? amount : 0};
    };
    return {(1 - coat) * (1 - m.metallic) * grey(layers.base) * s.opacity,
            {lobe(m.roughness, (1 - coat) * grey(layers.mirror(cosine))),
             lobe(m.coat_roughness, coat)}};
}

std::optional<Vec3> draw_mirrored(const Shading& s, double width, Vec2 place) {
    const auto [x, y] = perpendiculars(s.normal);
    const Vec3 viewer(-dot(x, s.view), -dot(y, s.view), viewer_cosine(s));
    const Vec3 facet = seen_facet(viewer, width, place);
    const double between = dot(viewer, facet);
    const Vec3 light = 2 * between * facet - viewer;
    if (light.z <= 0 || between <= 0) return std::nullopt;
    return unit(light.x * x + light.y * y + light.z * s.normal);
}

double mirrored_density(const Shading& s, double width, const Vec3& to_light) {
    const double cosine = std::clamp(dot(s.normal, unit(to_light - s.view)), 0.0, 1.0);
    return density(width, cosine) * unhidden(width, viewer_cosine(s)) / 2;
}

double mirrored_peak(const Shading& s, double width) {
    const double cosine = viewer_cosine(s);
    return reflected(width, {cosine, cosine, 1, cosine});
}

std::optional<Scattered> scatter(const Shading& s, double choice, Vec2 place) {
    const Layers layers(s);
    const double cosine = viewer_cosine(s);
    const double coat = layers.coat(cosine);
    const double by_coat = coat / (coat + max_component(layers.mirror(cosine)) + 1e-9);
    const bool on_coat = choice < by_coat;
    const double w = width(on_coat ? layers.material.coat_roughness : layers.material.roughness);
    const auto direction = draw_mirrored(s, w, place);
    if (!direction) return std::nullopt;
    const double between = dot(*direction, unit(*direction - s.view));
    // With visible normals, the weight is the Fresnel factor times the masking of the light.
    const double up = std::max(dot(*direction, s.normal), 0.0), unseen = 2 * up * unhidden(w, up);
    const Vec3 share = on_coat
                           ? Vec3(layers.coat(between) / by_coat)
                           : layers.mirror(between) * ((1 - layers.coat(between)) / (1 - by_coat));
    return Scattered{*direction, share * unseen, w < narrow};
}

}  // namespace candelabra
