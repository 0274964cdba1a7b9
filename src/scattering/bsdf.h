// SPDX-License-Identifier: GPL-3.0-or-later
// The BSDF of one layer of a surface at one point: how it scatters light to the viewer, and
// directions drawn as it does so. Lobes that send light in one direction only are in mirror.h.
#pragma once

#include "lighting/light_query.h"
#include "scattering/shading.h"

#include <array>
#include <optional>
#include <span>

namespace candelabra {

/// Which facets are asked for. Scattered rays find luminaires better than lobes of facets that are
/// very narrow.
enum class FacetLobes { all, wide, none };

/// What light is asked for; by default all.
struct BsdfTerms {
    bool highlights = true;  ///< phong and specular
    bool brilliance = true;  ///< of the diffuse part; false: as if it were 1
    FacetLobes facets = FacetLobes::all;
};

/// Throughout, light of colour 1 is that of a perpendicular irradiance of pi, as in POV-Ray, and
/// the cosine is in what is answered: pi times the BSDF times the cosine.
class Bsdf {
public:
    Bsdf(const Shading& shading, const ShadingRules& rules)
        : Bsdf(shading, rules, Part::whole, 0) {}

    /// Without diffuse reflection.
    static Bsdf highlights_of(const Shading& shading, const ShadingRules& rules) {
        return {shading, rules, Part::highlights, 0};
    }
    /// Of light that goes into a solid with that index of refraction, above 0, whatever the finish.
    static Bsdf entering(const Shading& shading, const ShadingRules& rules, double ior) {
        return {shading, rules, Part::entering, ior};
    }
    /// The same of a surface that is lit from both sides.
    Bsdf on_both_sides() const {
        Bsdf result = *this;
        result.shading_.both_sides = true;
        return result;
    }

    const Shading& shading() const { return shading_; }

    /// Whether light from anywhere would change what is seen.
    bool answers_light() const;

    /// Radiance towards the viewer by light of colour 1 from a unit direction. `grain` is the
    /// random number of `crand`, the same for all channels.
    Vec3 evaluate(const Vec3& to_light, const BsdfTerms& terms, double grain) const {
        return film(to_light) * evaluate_without_film(to_light, terms, grain);
    }
    /// The same without the colours of a thin film, which are apart: POV-Ray asks them once for all
    /// lights of a grid.
    Vec3 evaluate_without_film(const Vec3& to_light, const BsdfTerms&, double grain) const;
    Vec3 film(const Vec3& to_light) const;

    /// A unit direction, drawn about as the surface scatters light that comes from everywhere; u is
    /// in [0, 1)^2. Nothing where a highlight leads below the surface.
    std::optional<Vec3> sample(Vec2 u) const;
    /// Probability per steradian of that direction.
    double pdf(const Vec3& direction) const;

    /// Share of the directions that are drawn from highlights: about that of the light which they
    /// send on when it comes from everywhere. 0 of surfaces without highlights.
    double specular_probability() const { return specular_probability_; }
    /// What highlights send to the viewer of light of colour 1 that comes from everywhere, roughly.
    double highlights() const { return highlights_; }
    /// The same as the choice of luminaires knows it.
    BsdfLobes lobes() const;

private:
    enum class Part { whole, highlights, entering };
    /// A highlight.
    struct Lobe {
        enum Kind {
            about_mirrored,  ///< a power of the cosine to the mirrored view
            about_normal,    ///< of the cosine of the half vector to the normal
            facets
        };
        Kind kind = facets;
        double extent = 0;  ///< the exponent; of facets their width
        double share = 0;   ///< of all directions
    };

    Bsdf(const Shading&, const ShadingRules&, Part, double ior);
    void add(Lobe::Kind, double extent, double light);
    std::span<const Lobe> highlight_lobes() const { return {lobes_.data(), count_}; }
    Vec3 sample_diffuse(Vec2 u) const;
    std::optional<Vec3> sample(const Lobe&, Vec2 u) const;
    double pdf(const Lobe&, const Vec3& direction) const;

    Shading shading_;
    const ShadingRules* rules_;
    Part part_;
    double ior_;  ///< of the solid that light enters
    double specular_probability_ = 0, highlights_ = 0, diffuse_ = 0;
    std::array<Lobe, 2> lobes_;
    std::size_t count_ = 0;
};

}  // namespace candelabra
