// SPDX-License-Identifier: GPL-3.0-or-later
// Fog: the same everywhere, or thinning out above a height. Asked by the renderer for each part of
// a ray that is in the open.
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
    Vec3 up = Vec3(0, 1, 0);
    Vec3 turbulence = Vec3(0);
    double turb_depth = 0.5;
    int octaves = 6;
    double omega = 0.5;
    double lambda = 2;

    static const ItemInfo vocabulary;
};

/// What is wrong with it as a whole, as a sentence; empty when nothing is.
std::string problem(const Fog&);

/// The share of light that all fogs leave on a way of the length; they add nothing of their own.
/// Precondition: no fog has a problem.
Vec3 left_by(std::span<const Fog>, const Ray&, double distance, NoiseGenerator);

/// What all fogs make of the radiance that comes along the ray, from its origin to the distance,
/// which may be infinite. Precondition: no fog has a problem.
Veil veil_of(std::span<const Fog>, const Ray&, double distance, NoiseGenerator);

}  // namespace candelabra
