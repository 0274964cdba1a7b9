// SPDX-License-Identifier: GPL-3.0-or-later
// A point of a surface with the look of one of its layers, as it is seen from a direction: all that
// a BSDF is made of. Knows no world.
#pragma once

#include "base/colour.h"
#include "base/noise.h"
#include "base/vector.h"
#include "surface/finish.h"

namespace candelabra {

struct Shading {
    Vec3 position;
    Vec3 view;              ///< unit, direction of the ray that sees it
    Vec3 normal;            ///< unit, as shaded, on the side that is seen
    Vec3 smooth_normal;     ///< unit, as shaded without bumps, on the side that is seen
    Vec3 geometric_normal;  ///< unit, of the surface as it is, on the side that is seen
    const Finish* finish = nullptr;
    Colour colour;
    double opacity = 1;       ///< share of the surface that is not transparent
    bool both_sides = false;  ///< lit from behind as well
};

/// Settings of the scene that all surfaces are shaded by.
struct ShadingRules {
    Vec3 irid_wavelength = Vec3(0.7, 0.52, 0.48);  ///< of the colour channels, for thin films
    Vec3 ambient_light = Vec3(1);
    NoiseGenerator noise_generator = NoiseGenerator::full_range;
};

/// A direction after a mirror with that unit normal.
inline Vec3 mirrored(const Vec3& direction, const Vec3& normal) {
    return direction - 2 * dot(direction, normal) * normal;
}

}  // namespace candelabra
