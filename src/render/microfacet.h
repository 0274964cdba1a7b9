// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a surface of small facets: what of it goes to the viewer, and from where most of it
// comes. GGX facets that shade each other (Walter and others 2007), drawn as they are seen (Heitz
// 2018), over a diffuse base, under a clear coat.
#pragma once

#include "render/shade.h"

/// What light is asked for.
enum class Lobes {
    all,
    wide  ///< without the lobes that are so narrow that scattered rays find luminaires better
};

/// Radiance towards the viewer by light of colour 1 from a unit direction, in the sense of
/// response(). Precondition of all functions here: the finish has facets.
Vec3 facet_response(const Shading&, const Vec3& to_light, Lobes);

/// A direction from which light is reflected, and by what its radiance is multiplied.
struct Scattered {
    Vec3 direction;
    Vec3 weight;
    bool narrow;  ///< facet_response() of the wide lobes leaves it out
};

/// Numbers are uniform in [0, 1). Nothing when the facets reflect into the surface.
std::optional<Scattered> scatter(const Shading&, double choice, Vec2 place);
