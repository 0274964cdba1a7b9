// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/white_balance.h"

#include "film/auto_exposure.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Returns linear sRGB with luminance 1, by the inverse matrix of IEC 61966-2-1.
Rgb rgb_of(Vec2 xy) {
    const double x = xy.x / xy.y, z = (1 - xy.x - xy.y) / xy.y;
    return {3.2406 * x - 1.5372 - 0.4986 * z, -0.9689 * x + 1.8758 + 0.0415 * z,
            0.0557 * x - 0.2040 + 1.0570 * z};
}

}  // namespace

TEST_CASE("black bodies have the chromaticities of the tables", "[film][white_balance]") {
    // CIE 1931, 2 degrees, of Planck's law; illuminant A is 2856 kelvins.
    const Vec2 a = black_body_chromaticity(2856), hot = black_body_chromaticity(6500),
               ember = black_body_chromaticity(1500);
    CHECK(a.x == Approx(0.4476).margin(0.0005));
    CHECK(a.y == Approx(0.4074).margin(0.0005));
    CHECK(hot.x == Approx(0.3135).margin(0.0005));
    CHECK(hot.y == Approx(0.3237).margin(0.0005));
    CHECK(ember.x == Approx(0.5857).margin(0.001));
    CHECK(ember.y == Approx(0.3931).margin(0.001));
}

TEST_CASE("the light of the chosen temperature becomes white", "[film][white_balance]") {
    for (const double kelvins : {1200.0, 1900.0, 2856.0, 4000.0, 6500.0, 12000.0}) {
        INFO(kelvins << " K");
        const Rgb light = rgb_of(black_body_chromaticity(kelvins));
        const Rgb white = white_balance(kelvins)(light);
        for (int c = 0; c < 3; ++c) CHECK(white[c] == Approx(1).margin(0.002));
        CHECK(srgb_luminance(white) == Approx(srgb_luminance(light)).margin(0.002));
    }
    const Rgb any(0.3, 0.5, 0.9);
    CHECK(white_balance(0)(any) == any);
    // Daylight appears blue on film for lamps.
    const Rgb day = white_balance(3000)(Rgb(1));
    CHECK(day.b > day.g);
    CHECK(day.g > day.r);
}

}  // namespace candelabra
