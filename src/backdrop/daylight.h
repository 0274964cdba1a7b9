// SPDX-License-Identifier: GPL-3.0-or-later
// The sky and the sun by place and time, and by the formulas of those who measure them. A Daylight
// is as the scene states it; a DaylightSky is prepared for rays.
#pragma once

#include "base/rgb.h"
#include "photometry/light_units.h"
#include "photometry/sky_models.h"
#include "vocabulary/item_info.h"

#include <optional>
#include <string>

namespace candelabra {

/// How the distribution of light over the sky is found. Numbers above 0 are types of CIE's general
/// sky.
inline constexpr int weather_of_perez = 0;

struct Daylight {
    int distribution = 12;            ///< see above
    std::optional<int> type;          ///< a type of the general sky, in its place
    std::optional<Vec2> sun;          ///< height and azimuth in degrees
    std::optional<Vec2> place;        ///< degrees north and east
    std::optional<Vec3> date;         ///< year, month, day
    double time = 12;                 ///< in hours
    double zone = 0;                  ///< hours that the clock is ahead of universal time
    std::optional<double> zenith;     ///< radiance there
    std::optional<double> diffuse;    ///< illuminance by the sky, as a colour of a light source
    std::optional<double> direct;     ///< illuminance by the sun on a plane that faces it; the same
    std::optional<Vec2> irradiance;   ///< W/m2 of the sun on such a plane, and of the sky
    std::optional<double> clearness;  ///< see PerezWeather
    std::optional<double> brightness;   ///< the same
    double ground = 0.2;                ///< reflectance of what is below the horizon
    std::optional<double> temperature;  ///< in kelvin: the colour of all of the sky
    Vec3 up = Vec3(0, 1, 0);
    Vec3 north = Vec3(0, 0, 1);

    static const ItemInfo vocabulary;
    friend bool operator==(const Daylight&, const Daylight&) = default;

    bool is_perez() const { return !type && distribution == weather_of_perez; }
};

/// Returns a sentence about an error in the block as a whole; empty if there is none.
std::string problem(const Daylight&);

class DaylightSky {
public:
    /// Precondition: no problem.
    DaylightSky(const Daylight&, const LightUnits&);

    /// Radiance from a unit direction, without the sun.
    Rgb radiance(const Vec3& direction) const;

    /// The unit direction to the middle of the sun.
    const Vec3& sun() const { return sun_; }
    /// The sun's light as the colour of a light source; black if there is none.
    const Rgb& sunlight() const { return sunlight_; }
    /// Cosine of half of the angle that its disc fills.
    static double sun_edge();
    /// Radiance of its disc in a unit direction, black beside it.
    Rgb disc(const Vec3& direction) const;

private:
    Rgb colour_of(double radiance) const;

    SkyModel model_;
    Vec3 up_, sun_;
    Rgb sunlight_ = Rgb(0);
    double scale_ = 0;    ///< radiance over the model's luminance
    double ground_ = 0;   ///< radiance
    double white_;        ///< cd/m2 of radiance 1
    Rgb hue_ = Rgb(1);    ///< of the sky, if it is not blue
    bool blue_ = false;   ///< whether it has colours by its luminance
};

}  // namespace candelabra
