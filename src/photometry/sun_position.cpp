// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/sun_position.h"

#include "base/degrees.h"
#include "base/elementary.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Days from the noon that began 1 January 2000 to the beginning of a day.
double days_since_2000(const Vec3& date) {
    // Years begin in March, so that the day that is left out is the last one.
    const double shift = std::floor((14 - date.y) / 12);
    const double year = date.x + 4800 - shift, month = date.y + 12 * shift - 3;
    const double number = date.z + std::floor((153 * month + 2) / 5) + 365 * year +
                          std::floor(year / 4) - std::floor(year / 100) + std::floor(year / 400) -
                          32045;
    return number - 2451545 - 0.5;
}

double sine(double degrees) { return math::sin(degrees * radians_per_degree); }
double cosine(double degrees) { return math::cos(degrees * radians_per_degree); }

}  // namespace

int day_of_year(const Vec3& date) {
    return static_cast<int>(days_since_2000(date) - days_since_2000({date.x, 1, 1})) + 1;
}

SunPosition sun_position(const Vec2& place, const Vec3& date, double hours) {
    const double begin = days_since_2000(date), days = begin + hours / 24;
    const double mean = 280.460 + 0.9856474 * days, anomaly = 357.528 + 0.9856003 * days;
    const double longitude = mean + 1.915 * sine(anomaly) + 0.020 * sine(2 * anomaly);
    const double tilt = 23.439 - 4e-7 * days;
    const double east = sine(longitude) * cosine(tilt), ahead = cosine(longitude);
    const double declination = math::asin(sine(tilt) * sine(longitude));
    const double ascension = math::atan2(east, ahead) / radians_per_degree;
    const double sidereal = 15 * (18.697374558 + 24.06570982441908 * days);
    const double hour = sidereal + place.y - ascension;
    const double up = math::sin(declination), out = math::cos(declination);
    const double height = sine(place.x) * up + cosine(place.x) * out * cosine(hour);
    const double north = cosine(place.x) * up - sine(place.x) * out * cosine(hour);
    const double azimuth = math::atan2(-out * sine(hour), north) / radians_per_degree;
    return {math::asin(std::clamp(height, -1.0, 1.0)) / radians_per_degree,
            azimuth < 0 ? azimuth + 360 : azimuth};
}

}  // namespace candelabra
