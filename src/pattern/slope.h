// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns that depend on the direction of the surface: slope, relative to a fixed direction, and
// aoi, relative to the ray. 0 where there is no surface: in functions and for the sky.
#pragma once

#include "pattern/modifiers.h"

namespace candelabra {

struct Slope {
    std::optional<Vec3> direction;
    double low = 0;
    double high = 0;
    std::optional<Vec3> altitude;
    double altitude_low = 0;
    double altitude_high = 0;
    std::optional<Vec3> point_at;
    double point_low = 0;
    double point_high = 0;

    static const ItemInfo vocabulary;
};

struct Aoi {
    static const ItemInfo vocabulary;
};

double evaluate(const Slope&, const PatternPoint&);
double evaluate(const Aoi&, const PatternPoint&);

}  // namespace candelabra
