// SPDX-License-Identifier: GPL-3.0-or-later
// Microfacet reflection: GGX facets, sampled by visible normals, over a diffuse base and under a
// clear coat. A white surface reflects all light at every angle: light that facets do not reflect
// at once goes from facet to facet of a metal (Kulla and Conty, "Revisiting Physically Based
// Shading at Imageworks", 2017), or into the base.
#pragma once

#include "base/rgb.h"
#include "scattering/facet_albedo.h"
#include "scattering/shading.h"

#include <array>
#include <optional>

namespace candelabra {

/// A direction from which light is reflected, and the weight of its radiance.
struct Scattered {
    Vec3 direction;
    Rgb weight;
    bool narrow;  ///< omitted by Microfacets::response() with wide_only
};

/// Fraction of uniform light of colour 1 that is scattered to the viewer: in all directions, by the
/// base and from facet to facet, and about by the wide lobes (amount 0: no lobe).
struct FacetLight {
    struct Lobe {
        double width, amount;
    };
    double diffuse;
    std::array<Lobe, 2> wide;
};

/// The facets at a point, as they are seen by its viewer. A bent normal leads no light into the
/// real surface: what would go there is mirrored by it.
class Microfacets {
public:
    /// The finish has facets. The shading need not outlive this.
    explicit Microfacets(const Shading&);

    /// Radiance towards the viewer due to light of colour 1 from a unit direction, as in
    /// finish_response(). `wide_only` omits lobes so narrow that scattered rays find luminaires
    /// better.
    Rgb response(const Vec3& to_light, bool wide_only) const;
    /// The part of it that the diffuse base scatters, and the fraction of uniform light that a
    /// white base would scatter.
    Rgb base_response(const Vec3& to_light) const;
    double base_albedo() const { return (1 - material_.metallic) * viewer_left_.base; }
    /// Fraction of uniform light of colour 1 that the facets scatter to the viewer, without the
    /// base.
    Rgb facets_albedo() const;
    /// Fraction of light from behind that a clear pigment lets pass. Facets of what is no metal lie
    /// above it; a metal is as clear as its pigment, with holes where this is clear.
    double passing() const;
    FacetLight light() const;

    /// Returns a direction for which facets of this width mirror light to the viewer;
    /// mirrored_density() is its density per steradian. Returns nothing if light would go on from
    /// facet to facet.
    std::optional<Vec3> draw_mirrored(double width, Vec2 place) const;
    double mirrored_density(double width, const Vec3& to_light) const;
    /// The same with a density in proportion to the cosine.
    Vec3 draw_diffuse(Vec2 place) const;
    double diffuse_density(const Vec3& to_light) const;

    /// response() by facets of this width for light from the mirrored view direction, if they
    /// reflect all of it.
    double mirrored_peak(double width) const;
    /// The mean facet's normal, and the unit direction to the viewer. If the normal is bent so far
    /// that the mirrored view leads into the real surface, both are mirrored by it: light is.
    struct SeenFacets {
        Vec3 normal, viewer;
    };
    SeenFacets seen_facets() const;

    /// Draws from the lobes and from the light that goes from facet to facet, but not from the
    /// base. Arguments are uniform in [0, 1). Returns nothing as draw_mirrored() does.
    std::optional<Scattered> scatter(double choice, Vec2 place) const;

private:
    /// Fractions of the light from or to a direction: reflected by the coat, and left by the lobes
    /// for the base and for further facets.
    struct Left {
        double coat, base, further;
    };
    Left left_at(double cosine) const;
    Left left_of(const FacetAlbedo& own, const FacetAlbedo& coat) const;
    Left mean_left() const;

    Rgb mirror(double cosine) const;
    double coat(double cosine) const;
    double mirror_albedo(double facing) const;
    // Responses over the cosine of the light:
    Rgb base_at(const Left&) const;
    Rgb further_at(const Left&) const;
    std::optional<Vec3> draw_raw(double width, Vec2 place) const;
    Rgb at(const Vec3& to_light, bool wide_only) const;
    template <class Use>
    auto folded(const Vec3& to_light, const Use& use) const;

    Microfacet material_;
    Rgb colour_;  ///< of the base and of the metal
    double opacity_;
    double dielectric_;  ///< reflectance of the non-metallic part at normal incidence
    double metal_;       ///< share of the surface that is metal
    Rgb facing_;         ///< reflectance at normal incidence
    double grazing_;     ///< the same at grazing incidence
    Vec3 view_, geometric_normal_;
    Vec3 normal_;    ///< fitted to the viewer
    double viewer_;  ///< cosine of the viewer; above 0
    bool bent_;      ///< whether the normal is not that of the real surface
    Left viewer_left_;
    Rgb base_, further_;             ///< fractions of uniform light that they scatter to the viewer
    double per_base_, per_further_;  ///< inverse means of what is left for them; 0: nothing
};

}  // namespace candelabra
