// SPDX-License-Identifier: GPL-3.0-or-later
// Light sources whose light spreads from a point, so that they have a luminous flux. The functions
// are in light.cpp, beside those of the shapes of lights.
#pragma once

#include "light/light.h"

#include <numbers>

namespace candelabra {

/// Whether the light falls with the square of the distance from the source, in straight lines: then
/// its light in all directions is finite, and the same at any distance.
bool has_flux(const PointLight&);

/// Steradians that a light with full strength in all directions would fill to have the same flux.
/// Its colour times this is the flux, in colour of light times area. Precondition: has_flux().
double filled_steradians(const PointLight&);

/// A cone of directions.
struct LightCone {
    Vec3 axis;      ///< unit
    double cosine;  ///< of its half angle; -1: all directions

    double steradians() const { return 2 * std::numbers::pi * (1 - cosine); }
};
inline constexpr LightCone all_directions{Vec3(0, 0, 1), -1};

/// A cone outside of which a light that is not parallel has no strength.
LightCone cone_around(const PointLight&);

}  // namespace candelabra
