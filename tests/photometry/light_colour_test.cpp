// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/light_colour.h"

#include <catch2/catch.hpp>

#include <vector>

namespace candelabra {

TEST_CASE("a black body has the chromaticity and the colour of the tables", "[photometry]") {
    struct Row {
        double kelvin, x, y;
        Vec3 rgb;
    };
    for (const Row& row :
         std::vector<Row>{{1900, 0.537777, 0.411202, {2.63935, 0.61353, 0}},
                          {2200, 0.50563, 0.41521, {2.31429, 0.70358, 0.06530}},
                          {2700, 0.459859, 0.410599, {1.9351, 0.803553, 0.191796}},
                          {4000, 0.38044, 0.376747, {1.414, 0.924006, 0.533417}},
                          {6504, 0.313464, 0.323568, {1.04305, 0.983606, 1.0356}},
                          {10000, 0.28063, 0.28829, {0.87196, 0.99460, 1.43067}},
                          {20000, 0.25646, 0.25763, {0.74840, 0.98952, 1.84493}}}) {
        CAPTURE(row.kelvin);
        const Vec2 xy = planck_chromaticity(row.kelvin);
        CHECK(xy.x == Approx(row.x).epsilon(2e-4));
        CHECK(xy.y == Approx(row.y).epsilon(4e-4));
        const Rgb rgb = planck_colour(row.kelvin);
        for (int channel = 0; channel < 3; ++channel)
            CHECK(rgb[channel] == Approx(row.rgb[channel]).epsilon(1e-3).margin(1e-4));
        CHECK(light_luminance(rgb) == Approx(1));
    }
}

TEST_CASE("the red of embers has no negative blue, and luminance 1", "[photometry]") {
    const Rgb rgb = planck_colour(1000);
    CHECK(rgb.b == 0);
    CHECK(rgb.r > 4);
    CHECK(light_luminance(rgb) == Approx(1));
}

TEST_CASE("daylight at 6504 K is the white of D65", "[photometry]") {
    const Vec2 xy = daylight_chromaticity(6504);
    CHECK(xy.x == Approx(0.312714).epsilon(1e-4));
    CHECK(xy.y == Approx(0.329119).epsilon(1e-4));
    const Rgb rgb = daylight_colour(6504);
    CHECK(rgb.r == Approx(0.999422).epsilon(1e-3));
    CHECK(rgb.g == Approx(1.00026).epsilon(1e-3));
    CHECK(rgb.b == Approx(0.999139).epsilon(1e-3));
    // Both formulas meet at 7000 K.
    CHECK(daylight_chromaticity(7000).x == Approx(daylight_chromaticity(7000.001).x).epsilon(1e-4));
}

TEST_CASE("a watt of one wavelength has the lumens of the observer", "[photometry]") {
    CHECK(spectral_efficacy(555) == Approx(683));
    CHECK(spectral_efficacy(589) == Approx(525.333).epsilon(2e-3));
    CHECK(spectral_efficacy(450) == Approx(25.954).epsilon(2e-3));
    CHECK(spectral_efficacy(780) >= 0);
}

TEST_CASE("light of one wavelength has the hue of its part of the rainbow", "[photometry]") {
    const Rgb sodium = spectral_colour(589), green = spectral_colour(530),
              blue = spectral_colour(450);
    CHECK(sodium.r > sodium.g);
    CHECK(sodium.g > sodium.b);
    CHECK(green.g > 1);
    CHECK(green.r == 0);
    CHECK(blue.b > blue.r);
    for (double nanometres = min_wavelength; nanometres <= max_wavelength; nanometres += 0.5)
        CHECK(light_luminance(spectral_colour(nanometres)) == Approx(1));
}

}  // namespace candelabra
