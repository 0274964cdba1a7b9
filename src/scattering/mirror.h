// SPDX-License-Identifier: GPL-3.0-or-later
// The lobes of a surface that send light in one direction only: mirror reflection and refraction.
// They are kept apart from the BSDF, whose density would be infinite there.
#pragma once

#include "scattering/shading.h"

#include <optional>

namespace candelabra {

/// Share of unpolarised light that a smooth surface reflects; n is the index of refraction behind
/// it over the one in front.
double fresnel(double cosine, double n);

/// Share of the light from the mirror direction that is reflected to the viewer. The ratio is the
/// index of refraction in front of the surface over the one behind it.
Vec3 reflectivity(const Shading&, double ior_ratio);

/// The greatest share of the pixel that a reflection of that amount counts for: of one that does
/// not follow Fresnel's equations, in the direction that reflects most.
double greatest_reflectivity(const Reflection&, const Vec3& amount);

/// Where the ray that sees the surface is reflected to, as a unit direction. A bump may mirror the
/// ray into the surface; the normal without bumps brings it out again.
Vec3 reflected_direction(const Shading&);

/// Where the ray that sees the surface goes behind it, as a unit direction. Precondition: it is
/// not reflected in total.
Vec3 refracted_direction(const Shading&, double ior_ratio);

/// Whether the surface reflects all light, because none can go on behind it.
bool reflects_totally(const Shading&, double ior_ratio);

/// What metallic makes of a highlight's or a reflection's colour.
Vec3 metal_tint(const Vec3& pigment, double metallic, double cosine);

}  // namespace candelabra
