// SPDX-License-Identifier: GPL-3.0-or-later
// Rainbows: coloured arcs around a direction, seen by all rays in the atmosphere that do not end
// nearby. Evaluated by the renderer for each part of such a ray.
#pragma once

#include "base/ray.h"
#include "medium/veil.h"
#include "surface/colour_map.h"
#include "vocabulary/item_info.h"

#include <optional>
#include <span>

namespace candelabra {

struct Rainbow {
    Vec3 direction = Vec3(0);  ///< of the light: towards the centre of the arc
    double angle = 0;          ///< degrees from it to the middle of the band
    double width = 0;          ///< of the band in degrees
    double distance = 1e7;     ///< at which 37 % of the light from behind remain
    double jitter = 0;         ///< amplitude of random mixing of colours, relative to the width
    Vec3 up = Vec3(0, 1, 0);
    double arc_angle = 360;               ///< degrees of the circle that are visible
    std::optional<double> falloff_angle;  ///< degrees without fading; unset: all
    ColourMap map;                        ///< from the inner edge to the outer one

    static const ItemInfo vocabulary;
    friend bool operator==(const Rainbow&, const Rainbow&) = default;
};

/// Returns a sentence about an error in the rainbow as a whole; empty if there is none.
std::string problem(const Rainbow&);

/// Transmittance and added radiance of all rainbows along the ray, from its origin to a distance,
/// which may be infinite. `chance` is uniform in [0, 1), for jitter. Precondition: no rainbow has a
/// problem.
Veil veil_of(std::span<const Rainbow>, const Ray&, double distance, double chance);

}  // namespace candelabra
