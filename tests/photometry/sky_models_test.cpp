// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/sky_models.h"

#include "base/degrees.h"
#include "photometry/light_colour.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

constexpr double at_40 = 40 * radians_per_degree;  // the sun, 50 degrees from the zenith

/// Luminance over that of the zenith.
double relative(const SkyModel& sky, double zenith_angle, double azimuth) {
    const double z = zenith_angle * radians_per_degree, sun = 50 * radians_per_degree;
    const double to_sun = std::cos(z) * std::cos(sun) +
                          std::sin(z) * std::sin(sun) * std::cos(azimuth * radians_per_degree);
    return sky.luminance(std::cos(z), to_sun) / sky.luminance(1, std::cos(sun));
}

}  // namespace

TEST_CASE("general skies have the luminances of their formula", "[photometry]") {
    const SkyModel clear = cie_sky(12);
    CHECK(relative(clear, 60, 0) == Approx(6.87443).epsilon(1e-4));
    CHECK(relative(clear, 60, 90) == Approx(1.13122).epsilon(1e-4));
    CHECK(relative(clear, 60, 180) == Approx(0.940171).epsilon(1e-4));
    CHECK(relative(clear, 85, 120) == Approx(1.93198).epsilon(1e-4));
    // The overcast sky is near to the older formula (1 + 2 sin(height)) / 3.
    CHECK(relative(cie_sky(1), 60, 0) == Approx(2.0 / 3).epsilon(0.03));
    CHECK(relative(cie_sky(16), 60, 0) == Approx(2.0 / 3));
    CHECK(relative(cie_sky(5), 89, 30) == Approx(1));
}

TEST_CASE("general skies give the illuminance of their integral", "[photometry]") {
    struct Row {
        int type;
        double expected;
    };
    for (const Row& row :
         {Row{1, 2.44954}, Row{5, std::numbers::pi}, Row{12, 5.4053}, Row{13, 5.69025},
                           Row{16, 7 * std::numbers::pi / 9}}) {
        CAPTURE(row.type);
        const SkyModel sky = cie_sky(row.type);
        CHECK(sky.illuminance(at_40) / sky.luminance(1, std::sin(at_40)) ==
              Approx(row.expected).epsilon(1e-3));
    }
}

TEST_CASE("the all-weather sky has the coefficients and the integral of its formula",
          "[photometry]") {
    struct Row {
        PerezWeather weather;
        double height, a, b, c, d, e, integral, zenith;
    };
    const Row rows[] = {
        {{1.02, 0.2}, 40, 0.823168, -0.533229, 0.828239, -0.593518, -0.0140432, 6.17032, 0.35753},
        {{2, 0.3}, 40, -1.05251, -0.885272, 12.2619, -3.10935, 0.0164893, 5.04598, 0.204039},
        {{7, 0.1}, 60, -0.973471, -0.186531, 21.7583, -5.6515, 1.37869, 2.17716, 0.27916}};
    for (const Row& row : rows) {
        CAPTURE(row.weather.clearness);
        const double height = row.height * radians_per_degree;
        const SkyModel sky = perez_sky(row.weather, height);
        CHECK(sky.a == Approx(row.a).epsilon(1e-4));
        CHECK(sky.b == Approx(row.b).epsilon(1e-4));
        CHECK(sky.c == Approx(row.c).epsilon(1e-4));
        CHECK(sky.d == Approx(row.d).epsilon(1e-4));
        CHECK(sky.e == Approx(row.e).epsilon(1e-4));
        CHECK(sky.illuminance(height) == Approx(row.integral).epsilon(2e-3));
        CHECK(sky.luminance(1, std::sin(height)) / sky.illuminance(height) ==
              Approx(row.zenith).epsilon(2e-3));
    }
}

TEST_CASE("weather follows from irradiances, and they from it", "[photometry]") {
    const PerezWeather weather = PerezWeather::of({700, 120}, at_40);
    const Vec2 back = weather.irradiance(at_40);
    CHECK(back.x == Approx(700));
    CHECK(back.y == Approx(120));
    CHECK(weather.clearness == Approx(4.447).epsilon(1e-3));
    CHECK(weather.brightness == Approx(0.1363).epsilon(2e-3));
    const Daylighting light = daylighting(weather, {700, 120}, at_40);
    // By hand from the row of clearness 2.8 to 4.5, with 2 cm of water.
    CHECK(light.direct / 700 == Approx(99.54).epsilon(1e-3));
    CHECK(light.diffuse / 120 == Approx(148.29).epsilon(1e-3));
    const PerezWeather dull = PerezWeather::of({0, 150}, at_40);
    CHECK(dull.clearness == Approx(1));
    CHECK(daylighting(dull, {0, 150}, at_40).diffuse / 150 == Approx(115).margin(10));
    CHECK(PerezWeather::of({0, 0}, at_40).clearness == Approx(1));
}

TEST_CASE("usual days have the light that they have on earth", "[photometry]") {
    const double high = 60 * radians_per_degree, low = 1 * radians_per_degree;
    CHECK(usual_daylighting(1, high, 172).diffuse == Approx(18487).epsilon(1e-3));
    CHECK(usual_daylighting(1, high, 172).direct == 0);
    CHECK(usual_daylighting(8, high, 172).direct == Approx(49000).epsilon(0.05));
    CHECK(usual_daylighting(12, high, 172).direct == Approx(97000).epsilon(0.03));
    CHECK(usual_daylighting(12, low, 172).direct < 10);
    CHECK(usual_daylighting(12, high, 2).direct > 1.05 * usual_daylighting(12, high, 182).direct);
    // Civil twilight ends with 3 to 4 lux.
    const Daylighting dusk = usual_daylighting(12, -6 * radians_per_degree, 80);
    CHECK(dusk.direct == 0);
    CHECK(dusk.diffuse == Approx(3.2).epsilon(0.05));
}

TEST_CASE("the way through the air is long at the horizon", "[photometry]") {
    CHECK(air_mass(std::numbers::pi / 2) == Approx(1).epsilon(1e-3));
    CHECK(air_mass(30 * radians_per_degree) == Approx(2).epsilon(0.01));
    CHECK(air_mass(0) == Approx(38).epsilon(0.02));
    CHECK(air_mass(-1) == air_mass(0));
}

TEST_CASE("skies are blue where they are dark, and the low sun is red", "[photometry]") {
    const Rgb deep = blue_sky_colour(1500), pale = blue_sky_colour(30000);
    CHECK(deep.b / deep.r > 2);
    CHECK(pale.b / pale.r < 1.5);
    for (const double luminance : {0.0, 1e-9, 100.0, 1e9})
        CHECK(light_luminance(blue_sky_colour(luminance)) == Approx(1));
    const Rgb noon = sun_colour(std::numbers::pi / 2), evening = sun_colour(0.03);
    // As black bodies of 5500 and of 5000 kelvin.
    CHECK(noon.r / noon.b > 1.33);
    CHECK(noon.r / noon.b < 1.59);
    CHECK(evening.r / evening.b > 8);
    CHECK(light_luminance(evening) == Approx(1));
}

}  // namespace candelabra
