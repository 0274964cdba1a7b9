// SPDX-License-Identifier: GPL-3.0-or-later
// Where the sun stands over a place on earth.
#pragma once

#include "base/vector.h"

namespace candelabra {

/// Angles in degrees, without the refraction of the air.
struct SunPosition {
    double height;   ///< above the horizon, -90 to 90
    double azimuth;  ///< from north towards east, 0 to 360
};

/// By the low-precision formulas of the Astronomical Almanac, which are within 0.02 degrees from
/// 1950 to 2050. `place`: degrees north and east; `date`: year, month and day of the Gregorian
/// calendar; `hours` of universal time, which may lie outside of the day.
SunPosition sun_position(const Vec2& place, const Vec3& date, double hours);

/// Number of a day in its year, from 1.
int day_of_year(const Vec3& date);

}  // namespace candelabra
