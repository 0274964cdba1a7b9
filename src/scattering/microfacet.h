// SPDX-License-Identifier: GPL-3.0-or-later
// Microfacet reflection: GGX facets with shadowing and masking (Walter and others 2007), sampled by
// visible normals (Heitz 2018), over a diffuse base and under a clear coat.
#pragma once

#include "scattering/shading.h"

#include <array>
#include <optional>

namespace candelabra {

/// Radiance towards the viewer due to light of colour 1 from a unit direction, as in
/// finish_response(). `wide_only` omits lobes so narrow that scattered rays find luminaires better.
/// Precondition of all functions here: the finish has facets.
Vec3 facet_response(const Shading&, const Vec3& to_light, bool wide_only);

/// The part of it that the diffuse base below the facets scatters.
Vec3 facet_base_response(const Shading&, const Vec3& to_light);

/// Approximate fraction of uniform light of colour 1 that is scattered to the viewer: by the
/// diffuse base, and by the wide lobes (amount 0: no lobe).
struct FacetLight {
    struct Lobe {
        double width, amount;
    };
    double base;
    std::array<Lobe, 2> wide;
};
FacetLight facet_light(const Shading&);

/// Returns a direction from which facets of this width mirror light to the viewer;
/// mirrored_density() is its density per steradian. Returns nothing if the facets reflect into the
/// surface.
std::optional<Vec3> draw_mirrored(const Shading&, double width, Vec2 place);
double mirrored_density(const Shading&, double width, const Vec3& to_light);
/// facet_response() by these facets for light from the mirrored view direction, if they reflect all
/// of it.
double mirrored_peak(const Shading&, double width);

/// A direction from which light is reflected, and the weight of its radiance.
struct Scattered {
    Vec3 direction;
    Vec3 weight;
    bool narrow;  ///< omitted by facet_response() with wide_only
};

/// Arguments are uniform in [0, 1). Returns nothing if the facets reflect into the surface.
std::optional<Scattered> scatter(const Shading&, double choice, Vec2 place);

}  // namespace candelabra
