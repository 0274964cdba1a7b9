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

    static consteval auto vocabulary();
};

consteval auto PointLight::vocabulary() {
    using F = Field<PointLight>;
    return schema<PointLight>(
        "light_source", "A light without size that shines in all directions.",
        F{"location", &PointLight::location, positional, "where it is"},
        maybe(
            as_colour(F{"colour", &PointLight::colour, positional, "its colour, of any strength"})),
        F{"fade_distance", &PointLight::fade_distance, item,
          "distance at which it has its colour, when it fades; 0: never", at_least(0)},
        F{"fade_power", &PointLight::fade_power, item,
          "how fast it fades: 2 is nature's way; 0: it does not", at_least(0)},
        F{"shadowless", &PointLight::shadowless, flag,
          "nothing stops its light; gives no highlights"});
}

/// Every kind of light source.
using Light = std::variant<PointLight>;

/// The share of the colour that is left at a distance: 2 / (1 + (distance /
/// fade_distance)^fade_power) where it fades.
double fading(const PointLight&, double distance);
