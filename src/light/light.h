// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's own lights, which have no size. (Objects that emit are luminaires and need nothing from
// here.)
#pragma once

#include "vocabulary/kinds.h"

/// Shines equally in all directions. A surface that it lights straight on answers as its finish
/// says to that colour, at any distance unless it fades: a perpendicular irradiance of pi times the
/// colour.
struct PointLight {
    Vec3 location = Vec3(0);
    Vec3 colour = Vec3(0);
    double fade_distance = 0;
    double fade_power = 0;
    bool shadowless = false;

    static const ItemInfo vocabulary;
};

/// Every kind of light source.
using Light = std::variant<PointLight>;

/// The share of the colour that is left at a distance: 2 / (1 + (distance /
/// fade_distance)^fade_power) where it fades.
double fading(const PointLight&, double distance);
