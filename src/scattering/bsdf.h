// SPDX-License-Identifier: GPL-3.0-or-later
// The BSDF of one layer of a surface at one point: evaluates and samples how it scatters light
// towards the viewer. Delta lobes (mirror and refraction) are in mirror.h.
#pragma once

#include "base/rgb.h"
#include "lighting/light_query.h"
#include "scattering/microfacet.h"
#include "scattering/shading.h"

#include <array>
#include <optional>
#include <span>

namespace candelabra {

/// Which facet lobes to evaluate. Scattered rays find luminaires better than very narrow lobes do.
enum class FacetLobes { all, wide, none };

/// Which terms to evaluate; all by default.
struct BsdfTerms {
    bool highlights = true;  ///< phong and specular
    bool brilliance = true;  ///< of the diffuse term; false: as if it were 1
    FacetLobes facets = FacetLobes::all;
    /// Also light that comes through the real surface, as long as it is above the horizon of the
    /// shading normal: so POV-Ray counts light of its sources. Not for facets.
    bool through_surface = false;
};

/// The terms of a Lambertian layer.
inline constexpr BsdfTerms diffuse_terms{.highlights = false, .facets = FacetLobes::none};

/// Throughout, light of colour 1 has a perpendicular irradiance of pi, as in POV-Ray, and values
/// include the cosine: pi times the BSDF times the cosine.
class Bsdf {
public:
    Bsdf(const Shading& shading, const ShadingRules& rules)
        : Bsdf(shading, rules, Part::whole, 0) {}

    /// Returns the BSDF without diffuse reflection.
    static Bsdf highlights_of(const Shading& shading, const ShadingRules& rules) {
        return {shading, rules, Part::highlights, 0};
    }
    /// Returns the BSDF of light that enters a solid of this index of refraction, above 0, whatever
    /// its finish.
    static Bsdf entering(const Shading& shading, const ShadingRules& rules, double ior) {
        return {shading, rules, Part::entering, ior};
    }
    /// Returns the BSDF of a surface that is lit from both sides.
    Bsdf on_both_sides() const {
        Bsdf result = *this;
        result.shading_.both_sides = true;
        return result;
    }

    const Shading& shading() const { return shading_; }

    /// Whether light from any direction is scattered towards the viewer.
    bool answers_light() const;

    /// Radiance towards the viewer due to light of colour 1 from a unit direction. `grain` is the
    /// random number for `crand`, the same for all channels.
    Rgb evaluate(const Vec3& to_light, const BsdfTerms& terms, double grain) const {
        return film(to_light) * evaluate_without_film(to_light, terms, grain);
    }
    /// The same without the colours of a thin film, which film() returns: POV-Ray evaluates them
    /// once for all lights of a grid.
    Rgb evaluate_without_film(const Vec3& to_light, const BsdfTerms&, double grain) const;
    Rgb film(const Vec3& to_light) const;

    /// Returns a unit direction drawn roughly in proportion to the scattering of uniform light; u
    /// is in [0, 1)^2. Returns nothing if no light from the drawn direction counts.
    std::optional<Vec3> sample(Vec2 u) const;
    /// Density of sample() per steradian: above 0 wherever evaluate() is not 0.
    double pdf(const Vec3& direction) const;
    /// The same without highlights and lobes of facets: in proportion to the cosine, on the side or
    /// the sides that the diffuse term has.
    std::optional<Vec3> sample_diffuse(Vec2 u) const;
    double diffuse_pdf(const Vec3& direction) const;

    /// Approximate fraction of uniform light that the diffuse part scatters to the viewer, and the
    /// fraction that microfacets above it reflect.
    Rgb diffuse_albedo() const;
    Rgb facets_albedo() const { return facets_ ? facets_->facets_albedo() : Rgb(0); }

    /// Fraction of the directions that are drawn from highlights: about their fraction of the
    /// scattered uniform light. 0 for surfaces without highlights.
    double specular_probability() const { return specular_probability_; }
    /// Approximate radiance from highlights due to uniform light of colour 1.
    double highlights() const { return highlights_; }
    /// The lobes as the light samplers represent them.
    BsdfLobes lobes() const;

private:
    enum class Part { whole, highlights, entering };
    /// A highlight.
    struct Lobe {
        enum Kind {
            about_mirrored,  ///< power of the cosine to the mirrored view
            about_normal,    ///< power of the cosine between half vector and normal
            facets
        };
        Kind kind = facets;
        double extent = 0;  ///< the exponent; for facets, their width
        double share = 0;   ///< fraction of all drawn directions
    };

    Bsdf(const Shading&, const ShadingRules&, Part, double ior);
    void add(Lobe::Kind, double extent, double light);
    std::span<const Lobe> highlight_lobes() const { return {lobes_.data(), count_}; }
    double share_behind() const;
    bool counts(const Vec3& direction) const;
    std::optional<Vec3> sample(const Lobe&, Vec2 u) const;
    double pdf(const Lobe&, const Vec3& direction) const;

    Shading shading_;
    const ShadingRules* rules_;
    Part part_;
    std::optional<Microfacets> facets_;
    double ior_;  ///< of the solid that the light enters
    double specular_probability_ = 0, highlights_ = 0, diffuse_ = 0;
    std::array<Lobe, 2> lobes_;
    std::size_t count_ = 0;
};

}  // namespace candelabra
