// SPDX-License-Identifier: GPL-3.0-or-later
// Rainbows: coloured arcs around a direction, seen by all rays in the open that do not end near.
// Asked by the renderer for each part of such a ray.
#pragma once

#include "base/ray.h"
#include "medium/veil.h"
#include "surface/colour_map.h"
#include "vocabulary/item_info.h"

#include <optional>
#include <span>

namespace candelabra {

struct Rainbow {
    Vec3 direction = Vec3(0);  ///< in which light goes: the middle of the arc
    double angle = 0;          ///< degrees from there to the middle of the band
    double width = 0;          ///< of the band, in degrees
    double distance = 1e7;     ///< where 37 % of what is behind are left
    double jitter = 0;         ///< how far colours are mixed at random, over the width
    Vec3 up = Vec3(0, 1, 0);
    double arc_angle = 360;               ///< of the part of the circle that is there
    std::optional<double> falloff_angle;  ///< of the part that does not fade; unset: all
    ColourMap map;                        ///< from the inner edge to the outer

    static const ItemInfo vocabulary;
    friend bool operator==(const Rainbow&, const Rainbow&) = default;
};

/// What is wrong with it as a whole, as a sentence; empty when nothing is.
std::string problem(const Rainbow&);

/// What all rainbows make of the radiance that comes along the ray, from its origin to the
/// distance, which may be infinite. `chance` is uniform in [0, 1), for jitter. Precondition: no
/// rainbow has a problem.
Veil veil_of(std::span<const Rainbow>, const Ray&, double distance, double chance);

}  // namespace candelabra
