// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/daylight.h"

#include "base/degrees.h"
#include "photometry/light_colour.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>

namespace candelabra {

namespace {

constexpr double lux_to_colour = 1 / std::numbers::pi;  // where white is 1 cd/m2
const LightUnits candelas{1, 1};

Daylight at_sun(int type, double height, double azimuth) {
    Daylight day;
    day.type = type;
    day.sun = Vec2(height, azimuth);
    return day;
}

double luminance_of(const DaylightSky& sky, const Vec3& direction) {
    return light_luminance(sky.radiance(unit(direction)));
}

}  // namespace

TEST_CASE("a sky has the level that is stated", "[backdrop]") {
    Daylight day = at_sun(1, 40, 0);
    day.zenith = 5000;
    const DaylightSky overcast(day, candelas);
    CHECK(luminance_of(overcast, {0, 1, 0}) == Approx(5000));
    CHECK(luminance_of(overcast, {1, 1e-9, 0}) == Approx(5000 / 3.0).epsilon(0.1));
    CHECK(overcast.sunlight() == Rgb(0));
    // The ground gives back a fifth of 2.44954 times the zenith.
    CHECK(luminance_of(overcast, {0, -1, 0}) ==
          Approx(0.2 * 2.44954 * 5000 / std::numbers::pi).epsilon(1e-3));
    day.zenith.reset();
    day.diffuse = 10000 * lux_to_colour;
    CHECK(luminance_of(DaylightSky(day, candelas), {0, 1, 0}) ==
          Approx(10000 / 2.44954).epsilon(1e-3));
    // A usual overcast day.
    day.diffuse.reset();
    CHECK(luminance_of(DaylightSky(day, candelas), {0, 1, 0}) ==
          Approx((300 + 21000 * std::sin(40 * radians_per_degree)) / 2.44954).epsilon(1e-3));
    // White of 200 cd/m2.
    CHECK(light_luminance(DaylightSky(day, {1, 200}).radiance({0, 1, 0})) * 200 ==
          Approx(luminance_of(DaylightSky(day, candelas), {0, 1, 0})));
}

TEST_CASE("the sun stands where the compass says, and has its disc", "[backdrop]") {
    const auto sun = [](double azimuth, const Vec3& up, const Vec3& north) {
        Daylight day = at_sun(12, 30, azimuth);
        day.up = up;
        day.north = north;
        return DaylightSky(day, candelas).sun();
    };
    const double level = std::cos(30 * radians_per_degree);
    CHECK(length(sun(0, {0, 1, 0}, {0, 0, 1}) - Vec3(0, 0.5, level)) < 1e-12);
    CHECK(length(sun(90, {0, 1, 0}, {0, 0, 1}) - Vec3(level, 0.5, 0)) < 1e-12);
    CHECK(length(sun(180, {0, 2, 0}, {1, 5, 0}) - Vec3(-level, 0.5, 0)) < 1e-12);

    Daylight day = at_sun(12, 30, 0);
    day.direct = 80000 * lux_to_colour;
    const DaylightSky sky(day, candelas);
    CHECK(std::numbers::pi * light_luminance(sky.sunlight()) == Approx(80000));
    const double solid_angle = 2 * std::numbers::pi * (1 - std::cos(0.2666 * radians_per_degree));
    CHECK(light_luminance(sky.disc(sky.sun())) * solid_angle == Approx(80000).epsilon(1e-3));
    const auto beside = [&](double degrees) {
        return unit(sky.sun() + std::tan(degrees * radians_per_degree) * Vec3(1, 0, 0));
    };
    CHECK(sky.disc(beside(0.26)) != Rgb(0));
    CHECK(sky.disc(beside(0.28)) == Rgb(0));
    CHECK(luminance_of(sky, sky.sun()) < 1e5);
    day.direct = 0;
    CHECK(DaylightSky(day, candelas).disc(sky.sun()) == Rgb(0));
}

TEST_CASE("place, date and time are the same as the sun that they give", "[backdrop]") {
    Daylight day;
    day.place = Vec2(52.5, 13.4);
    day.date = Vec3(2026, 6, 21);
    day.time = 13.1;
    day.zone = 2;
    const DaylightSky noon(day, candelas);
    CHECK(std::asin(noon.sun().y) / radians_per_degree == Approx(60.93).margin(0.1));
    CHECK(noon.sun().z < -0.4);
    day.time = 1;
    const DaylightSky night(day, candelas);
    CHECK(night.sun().y < 0);
    CHECK(night.sunlight() == Rgb(0));
    CHECK(luminance_of(night, {0, 1, 0}) < 1);
    CHECK(luminance_of(night, {0, 1, 0}) > 0);
}

TEST_CASE("weather by irradiances or by its two numbers gives one sky", "[backdrop]") {
    Daylight day;
    day.distribution = weather_of_perez;
    day.sun = Vec2(40, 180);
    day.irradiance = Vec2(700, 120);
    const DaylightSky measured(day, candelas);
    const PerezWeather weather = PerezWeather::of({700, 120}, 40 * radians_per_degree);
    day.irradiance.reset();
    day.clearness = weather.clearness;
    day.brightness = weather.brightness;
    const DaylightSky stated(day, candelas);
    for (const Vec3 direction : {Vec3(0, 1, 0), Vec3(1, 0.2, 1), Vec3(0, 0.6, -0.7)})
        CHECK(luminance_of(measured, direction) == Approx(luminance_of(stated, direction)));
    CHECK(light_luminance(measured.sunlight()) == Approx(light_luminance(stated.sunlight())));
    CHECK(std::numbers::pi * light_luminance(measured.sunlight()) == Approx(73000).epsilon(0.05));
}

TEST_CASE("clear skies are blue unless a temperature is stated", "[backdrop]") {
    Daylight day = at_sun(12, 40, 180);
    const Rgb zenith = DaylightSky(day, candelas).radiance({0, 1, 0});
    CHECK(zenith.b > 1.5 * zenith.r);
    const Rgb cloud = DaylightSky(at_sun(1, 40, 180), candelas).radiance({0, 1, 0});
    CHECK(cloud.b == Approx(cloud.r).epsilon(0.01));
    day.temperature = 5000;
    const Rgb warm = DaylightSky(day, candelas).radiance({0, 1, 0});
    CHECK(warm.r > 1.3 * warm.b);
    CHECK(light_luminance(warm) == Approx(light_luminance(zenith)));
}

TEST_CASE("contradictions in a sky are told", "[backdrop]") {
    const auto says = [](const std::function<void(Daylight&)>& change, const std::string& part) {
        Daylight day = at_sun(12, 40, 180);
        change(day);
        CAPTURE(part, problem(day));
        CHECK(problem(day).find(part) != std::string::npos);
    };
    CHECK(problem(at_sun(12, 40, 180)).empty());
    says([](Daylight& day) { day.sun.reset(); }, "needs the sun");
    says([](Daylight& day) { day.place = Vec2(0, 0); }, "`place` and `date` together");
    says(
        [](Daylight& day) {
            day.place = Vec2(0, 0);
            day.date = Vec3(2026, 1, 1);
        },
        "by `sun` or by");
    says([](Daylight& day) { day.sun = Vec2(91, 0); }, "above 90");
    says(
        [](Daylight& day) {
            day.sun.reset();
            day.place = Vec2(0, 0);
            day.date = Vec3(2026, 13, 1);
        },
        "a month");
    says(
        [](Daylight& day) {
            day.sun.reset();
            day.place = Vec2(95, 0);
            day.date = Vec3(2026, 12, 1);
        },
        "degrees north");
    says([](Daylight& day) { day.north = Vec3(0, 2, 0); }, "same direction");
    says([](Daylight& day) { day.zenith = day.diffuse = 1; }, "give one");
    says([](Daylight& day) { day.clearness = 2; }, "for `perez`");
    says(
        [](Daylight& day) {
            day.type.reset();
            day.distribution = weather_of_perez;
            day.clearness = 2;
        },
        "`perez` needs");
    Daylight dull;
    dull.distribution = 16;
    CHECK_FALSE(problem(dull).empty());
    dull.diffuse = 1;
    CHECK(problem(dull).empty());
    dull.direct = 1;
    CHECK_FALSE(problem(dull).empty());
}

}  // namespace candelabra
