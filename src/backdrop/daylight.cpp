// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/daylight.h"

#include "base/circle.h"
#include "base/degrees.h"
#include "base/elementary.h"
#include "photometry/light_colour.h"
#include "photometry/sun_position.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Half of the angle that the sun fills at its mean distance.
constexpr double sun_radius = 0.2666 * radians_per_degree;
/// Colour of skies that are not blue.
constexpr double cloud_temperature = 6504;
/// The types of the general sky, and the least clearness, with a blue sky.
constexpr int first_blue_type = 7, last_blue_type = 15;
constexpr double least_blue_clearness = 1.5;
/// The day of the year where no date is given.
constexpr int usual_day = 93;

int sky_type(const Daylight& day) { return day.type.value_or(day.distribution); }

bool within(const Vec3& date) {
    return date.x >= 1800 && date.x <= 2200 && date.y >= 1 && date.y <= 12 && date.z >= 1 &&
           date.z <= 31 && date == glm::floor(date);
}

SunPosition position_of_sun(const Daylight& day) {
    if (day.sun) return {day.sun->x, day.sun->y};
    if (day.place && day.date) return sun_position(*day.place, *day.date, day.time - day.zone);
    return {90, 0};
}

bool knows_sun(const Daylight& day) { return day.sun || (day.place && day.date); }

/// Illuminances in lux that the block does not state itself.
Daylighting light_by_rule(const Daylight& day, double height) {
    const int number = day.date ? day_of_year(*day.date) : usual_day;
    if (!day.is_perez()) return usual_daylighting(sky_type(day), height, number);
    const double above = std::fmax(height, 0);
    if (day.irradiance)
        return daylighting(PerezWeather::of(*day.irradiance, above), *day.irradiance, above);
    const PerezWeather weather{*day.clearness, *day.brightness};
    return daylighting(weather, weather.irradiance(above), above);
}

PerezWeather weather_of(const Daylight& day, double height) {
    return day.irradiance ? PerezWeather::of(*day.irradiance, height)
                          : PerezWeather{*day.clearness, *day.brightness};
}

}  // namespace

const ItemInfo Daylight::vocabulary = described<Daylight>([] {
    using F = Field<Daylight>;
    constexpr auto is = [](std::string_view name, int distribution, std::string_view help) {
        return chooses<Daylight>(name, &Daylight::distribution, distribution, help);
    };
    return schema<Daylight>(
        "sky_luminance",
        {"The sky and the sun as they are measured: both light the scene, in true numbers.",
         "sky_luminance { clear place <52.5, 13.4> date <2026, 6, 21> time 15 zone 2 }",
         "sky_luminance { cie overcast zenith nit(5000) ground 0.1 temperature 6500 }",
         "sky_luminance { uniform diffuse lux(10000) up y north z }",
         "sky_luminance { partly_cloudy sun <40, 180> direct lux(30000) }",
         "sky_luminance { turbid sun <20, 250> }", "sky_luminance { type 6 sun <40, 180> }",
         "sky_luminance { perez irradiance <600, 120> sun <40, 180> }",
         "sky_luminance { perez clearness 3 brightness 0.2 sun <40, 180> }"},
        is("cie", 12, "the general sky of CIE, whose name or `type` may follow; else `clear`"),
        is("overcast", 16,
           "the overcast sky of daylight factors, three times as bright above as at the horizon"),
        is("uniform", 5, "an even luminance from the zenith to the horizon"),
        is("partly_cloudy", 8, "type 8 of CIE: partly cloudy, bright around the sun"),
        is("clear", 12, "the clear sky of CIE; the default"),
        is("turbid", 13, "the clear sky of CIE over polluted air"),
        F{"type", &Daylight::type, item,
          "one of the types of CIE's general sky (ISO 15469), 16 is `overcast`", between(1, 16)},
        is("perez", weather_of_perez,
           "the all-weather sky of Perez, by `irradiance`, or by `clearness` and `brightness`"),
        F{"sun", &Daylight::sun, item,
          "height and azimuth of the sun in degrees: from the horizon, and from north towards "
          "east"},
        F{"place", &Daylight::place, item,
          "latitude and longitude in degrees, north and east above 0, by which the sun stands"},
        F{"date", &Daylight::date, item, "year, month and day"},
        F{"time", &Daylight::time, item, "hours of the clock", between(0, 24)},
        F{"zone", &Daylight::zone, item,
          "hours that the clock is ahead of universal time: 1 in Berlin in winter, -5 in New York",
          between(-14, 14)},
        F{"zenith", &Daylight::zenith, item, "luminance in the zenith, as nit(5000)", at_least(0)},
        F{"diffuse", &Daylight::diffuse, item,
          "illuminance of level ground by the sky, as lux(10000); without it, the usual one",
          at_least(0)},
        F{"direct", &Daylight::direct, item,
          "illuminance by the sun of what faces it, as lux(80000), or 0; without it, the usual one",
          at_least(0)},
        F{"irradiance", &Daylight::irradiance, item,
          "W/m2 of the sun on what faces it, and of the sky on level ground, as in weather files",
          at_least(0)},
        F{"clearness", &Daylight::clearness, item, "of Perez: 1 is overcast, above 6.2 very clear",
          between(1, 100)},
        F{"brightness", &Daylight::brightness, item, "of Perez: 0.05 is dark, 0.5 bright",
          between(0.01, 0.6)},
        F{"ground", &Daylight::ground, item, "reflectance of what lies below the horizon",
          between(0, 1)},
        F{"temperature", &Daylight::temperature, item,
          "kelvins of daylight that all of the sky has; without it, clear skies are blue",
          between(min_daylight, max_daylight)},
        F{"up", &Daylight::up, item, "where the zenith is"},
        F{"north", &Daylight::north, item, "where north is"});
});

std::string problem(const Daylight& day) {
    const std::string block = "`sky_luminance` ";
    if (day.place.has_value() != day.date.has_value())
        return block + "needs `place` and `date` together";
    if (day.sun && day.place) return block + "has the sun by `sun` or by `place` and `date`";
    if (day.sun && std::abs(day.sun->x) > 90) return "the height of `sun` is above 90 degrees";
    if (day.place && (std::abs(day.place->x) > 90 || std::abs(day.place->y) > 360))
        return "`place` is degrees north from -90 to 90, and degrees east from -360 to 360";
    if (day.date && !within(*day.date))
        return "`date` is a year from 1800 to 2200, a month and a day, as <2026, 6, 21>";
    if (cross(day.up, day.north) == Vec3(0)) return "`north` and `up` have the same direction";
    if (day.zenith && day.diffuse) return "`zenith` and `diffuse` say the same: give one";
    const bool stated = day.irradiance || (day.clearness && day.brightness);
    if (day.is_perez() && !stated)
        return "`perez` needs `irradiance`, or `clearness` and `brightness`";
    if (day.is_perez() && day.irradiance && (day.clearness || day.brightness))
        return "`perez` has its weather by `irradiance` or by `clearness` and `brightness`";
    if (!day.is_perez() && (day.irradiance || day.clearness || day.brightness))
        return "`irradiance`, `clearness` and `brightness` are for `perez`";
    const SkyModel even = day.is_perez() ? SkyModel{} : cie_sky(sky_type(day));
    const bool by_sun = day.is_perez() || even.c != 0 || even.e != 0;
    const bool measured = day.zenith || day.diffuse;
    if (!knows_sun(day) && (by_sun || !measured || day.direct.value_or(0) > 0))
        return block +
               "needs the sun: `sun <40, 180>`, or `place <52.5, 13.4> date <2026, 6, 21>"
               " time 12`";
    return {};
}

DaylightSky::DaylightSky(const Daylight& day, const LightUnits& units)
    : up_(unit(day.up)), white_(units.white) {
    const SunPosition position = position_of_sun(day);
    const double height = position.height * radians_per_degree;
    const Vec3 east = unit(cross(day.up, day.north)), north = cross(east, up_);
    const auto [rise, aside] = math::sin_cos(height);
    sun_ = unit(rise * up_ + aside * on_circle(position.azimuth * radians_per_degree, north, east));
    // Below the horizon, the sky is bright where the sun went down.
    const double above = std::fmax(height, 0);
    model_ = day.is_perez() ? perez_sky(weather_of(day, above), above) : cie_sky(sky_type(day));
    const Daylighting usual = light_by_rule(day, height);
    // Illuminances over pi times the luminance of white.
    const double diffuse = day.diffuse.value_or(units.colour(usual.diffuse));
    const double direct = height > 0 ? day.direct.value_or(units.colour(usual.direct)) : 0;
    const double whole = model_.illuminance(above);
    const double overhead = model_.luminance(1, math::sin(above));
    scale_ = day.zenith ? *day.zenith / overhead : whole > 0 ? pi * diffuse / whole : 0;
    sunlight_ = direct > 0 ? direct * sun_colour(above) : Rgb(0);
    ground_ = day.ground * (scale_ * whole / pi + direct * std::fmax(rise, 0));
    const int type = sky_type(day);
    const bool clear = day.is_perez() ? weather_of(day, above).clearness >= least_blue_clearness
                                      : type >= first_blue_type && type <= last_blue_type;
    blue_ = clear && !day.temperature;
    hue_ = daylight_colour(day.temperature.value_or(cloud_temperature));
}

double DaylightSky::sun_edge() {
    static const double edge = math::cos(sun_radius);
    return edge;
}

Rgb DaylightSky::radiance(const Vec3& direction) const {
    const double rise = dot(direction, up_);
    if (rise < 0) return ground_ * hue_;
    const double there = scale_ * model_.luminance(rise, dot(direction, sun_));
    return there * (blue_ ? blue_sky_colour(there * white_) : hue_);
}

Rgb DaylightSky::disc(const Vec3& direction) const {
    if (sunlight_ == Rgb(0) || dot(direction, sun_) < sun_edge()) return Rgb(0);
    const double sine = math::sin(sun_radius);
    return sunlight_ / (sine * sine);
}

}  // namespace candelabra
