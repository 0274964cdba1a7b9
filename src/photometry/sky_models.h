// SPDX-License-Identifier: GPL-3.0-or-later
// How the luminance of a sky varies with the direction, and how much light sky and sun give: the
// formulas of CIE, Perez and IES.
#pragma once

#include "base/rgb.h"
#include "base/vector.h"

namespace candelabra {

/// The form that the general sky of CIE (ISO 15469) and the all-weather sky of Perez share: a
/// gradation by the zenith angle, and an indicatrix by the angle from the sun.
struct SkyModel {
    double a, b;     ///< 1 + a exp(b / cos(zenith angle))
    double c, d, e;  ///< 1 + c (exp(d angle) - base) + e cos^2(angle)
    double base;
    bool linear = false;  ///< the gradation is (1 + 2 cos(zenith angle)) / 3

    /// Up to a factor. The zenith angle is at most 90 degrees; never below 0.
    double luminance(double cosine_to_zenith, double cosine_to_sun) const;
    /// Illuminance of a horizontal plane over that factor. `sun_height` in radians, 0 to pi / 2.
    double illuminance(double sun_height) const;
};

/// One of the types of the general sky. 1: overcast, 5: uniform, 12: clear, 13: clear and turbid,
/// 16: overcast by the older formula of Moon and Spencer, on which daylight factors rest.
SkyModel cie_sky(int type);

/// Weather by the two numbers of Perez.
struct PerezWeather {
    double clearness;   ///< 1: overcast; above 6.2: very clear
    double brightness;  ///< of the sky, over that of the sunlight outside of the atmosphere

    /// From irradiances in W/m2: of the sun on a plane that faces it, and of the sky on a level
    /// one, as weather files have them.
    static PerezWeather of(const Vec2& irradiance, double sun_height);
    /// The other way round.
    Vec2 irradiance(double sun_height) const;
};

/// `sun_height` in radians, 0 to pi / 2.
SkyModel perez_sky(const PerezWeather&, double sun_height);

/// Illuminances in lux: of the sun on a plane that faces it, and of the sky on a horizontal one.
struct Daylighting {
    double direct, diffuse;
};
/// That of weather by the luminous efficacies of Perez, for 2 cm of water in the air.
Daylighting daylighting(const PerezWeather&, const Vec2& irradiance, double sun_height);
/// The usual one under a general sky, by the formulas of IES: types 1 to 5 and 16 are overcast,
/// 6 to 10 partly cloudy, others clear. `day`: of the year. A sun below the horizon makes twilight.
Daylighting usual_daylighting(int type, double sun_height, int day);

/// Length of the way of light through the air, over that from the zenith (Kasten and Young).
double air_mass(double sun_height);

/// Colour of a part of a clear sky by its luminance in cd/m2 (Chain, Dumortier and Fontoynont), and
/// of the sun by its height. Linear Rec. 709 with luminance 1.
Rgb blue_sky_colour(double luminance);
Rgb sun_colour(double sun_height);

}  // namespace candelabra
