// SPDX-License-Identifier: GPL-3.0-or-later
// Delta lobes of a surface: mirror reflection and refraction. They are separate from the BSDF,
// whose density would be infinite there.
#pragma once

#include "base/rgb.h"
#include "scattering/shading.h"

#include <optional>

namespace candelabra {

/// Fraction of unpolarised light that a smooth surface reflects; n is the index of refraction
/// behind it over the one in front.
double fresnel(double cosine, double n);

/// Fraction of the light from the mirror direction that is reflected to the viewer. `ior_ratio` is
/// the index of refraction in front of the surface over the one behind it.
Rgb reflectivity(const Shading&, double ior_ratio);

/// Upper bound of the weight in the pixel of a reflection of this amount. For reflections without
/// `fresnel`, this is the weight in the direction that reflects most.
double greatest_reflectivity(const Reflection&, const Rgb& amount);

/// Unit direction in which the viewing ray is reflected. A bump may reflect the ray into the
/// surface; the normal without bumps then brings it out again.
Vec3 reflected_direction(const Shading&);

/// Unit direction of the refracted viewing ray. Precondition: no total internal reflection.
Vec3 refracted_direction(const Shading&, double ior_ratio);

/// Whether the reflection is total.
bool reflects_totally(const Shading&, double ior_ratio);

/// Colour of a highlight or reflection tinted by `metallic`.
Rgb metal_tint(const Rgb& pigment, double metallic, double cosine);

}  // namespace candelabra
