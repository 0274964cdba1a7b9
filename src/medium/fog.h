// SPDX-License-Identifier: GPL-3.0-or-later
// Fog of constant density, or one that thins out above a height. Evaluated by the renderer for each
// part of a ray in the atmosphere.
#pragma once

#include "base/colour.h"
#include "base/noise.h"
#include "base/ray.h"
#include "medium/veil.h"
#include "vocabulary/item_info.h"

#include <span>

namespace candelabra {

struct Fog {
    Colour colour;
    int fog_type = 1;  ///< 2: thins out above fog_offset
    double distance = 0;
    double fog_offset = 0;
    double fog_alt = 0;
    Vec3 up = Vec3(0, 1, 0);  ///< 0: as in POV-Ray, everything in a fog_type 2 is black
    Vec3 turbulence = Vec3(0);
    double turb_depth = 0.5;
    int octaves = 6;
    double omega = 0.5;
    double lambda = 2;

    static const ItemInfo vocabulary;
};

/// Transmittance of all fogs along the ray up to a distance, without the light they add. It is 0 in
/// a black fog.
Rgb left_by(std::span<const Fog>, const Ray&, double distance, NoiseGenerator);

/// Transmittance and added radiance of all fogs along the ray, from its origin to a distance, which
/// may be infinite. In a black fog both are 0.
Veil veil_of(std::span<const Fog>, const Ray&, double distance, NoiseGenerator);

}  // namespace candelabra
