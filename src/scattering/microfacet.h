// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a surface of small facets: what of it goes to the viewer, and from where most of it
// comes. GGX facets that shade each other (Walter and others 2007), drawn as they are seen (Heitz
// 2018), over a diffuse base, under a clear coat.
#pragma once

#include "scattering/shading.h"

#include <array>
#include <optional>

namespace candelabra {

/// Radiance towards the viewer by light of colour 1 from a unit direction, in the sense of
/// finish_response(). With `wide_only` without the lobes that are so narrow that scattered rays
/// find luminaires better. Precondition of all functions here: the finish has facets.
Vec3 facet_response(const Shading&, const Vec3& to_light, bool wide_only);

/// The part of it that the diffuse base below the facets sends on.
Vec3 facet_base_response(const Shading&, const Vec3& to_light);

/// What goes to the viewer of light of colour 1 that comes from everywhere, roughly, as a share: by
/// the diffuse base, and by the wide lobes (0: there is none).
struct FacetLight {
    struct Lobe {
        double width, amount;
    };
    double base;
    std::array<Lobe, 2> wide;
};
FacetLight facet_light(const Shading&);

/// A direction from which facets of that width mirror light to the viewer, with the density per
/// steradian that this has. Nothing when the facets reflect into the surface.
std::optional<Vec3> draw_mirrored(const Shading&, double width, Vec2 place);
double mirrored_density(const Shading&, double width, const Vec3& to_light);
/// facet_response() by such facets for light from the mirrored view, if they reflect all of it.
double mirrored_peak(const Shading&, double width);

/// A direction from which light is reflected, and by what its radiance is multiplied.
struct Scattered {
    Vec3 direction;
    Vec3 weight;
    bool narrow;  ///< facet_response() of the wide lobes leaves it out
};

/// Numbers are uniform in [0, 1). Nothing when the facets reflect into the surface.
std::optional<Scattered> scatter(const Shading&, double choice, Vec2 place);

}  // namespace candelabra
