// SPDX-License-Identifier: GPL-3.0-or-later
// A point of a surface with the look of one of its layers, as seen from a direction: all inputs of
// a BSDF. Independent of the world.
#pragma once

#include "base/colour.h"
#include "base/noise.h"
#include "base/rgb.h"
#include "base/vector.h"
#include "surface/finish.h"

namespace candelabra {

struct Shading {
    Vec3 position;
    Vec3 view;              ///< unit, direction of the viewing ray
    Vec3 normal;            ///< unit shading normal, on the side that is seen
    Vec3 smooth_normal;     ///< unit shading normal without bumps, on the side that is seen
    Vec3 geometric_normal;  ///< unit normal of the actual surface, on the side that is seen
    const Finish* finish = nullptr;
    Colour colour;
    double opacity = 1;       ///< fraction of the surface that is not transparent
    bool both_sides = false;  ///< also lit from behind
};

/// Settings of the scene for the shading of all surfaces.
struct ShadingRules {
    Rgb irid_wavelength = Rgb(0.7, 0.52, 0.48);  ///< of the colour channels, for thin films
    Rgb ambient_light = Rgb(1);
    NoiseGenerator noise_generator = NoiseGenerator::full_range;
};

/// The direction reflected by a mirror with this unit normal.
inline Vec3 mirrored(const Vec3& direction, const Vec3& normal) {
    return direction - 2 * dot(direction, normal) * normal;
}

}  // namespace candelabra
