// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/lamp_tilt.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a factor of a tilt lies between those of the nearest angles", "[photometry]") {
    const LampTilt half{1, {0, 30, 90}, {1, 0.9, 0.6}};
    CHECK(factor_of_tilt(half, 0) == 1);
    CHECK(factor_of_tilt(half, 15) == Approx(0.95));
    CHECK(factor_of_tilt(half, 30) == Approx(0.9));
    CHECK(factor_of_tilt(half, 60) == Approx(0.75));
    CHECK(factor_of_tilt(half, 90) == Approx(0.6));
    // The table ends at the horizontal: a lamp that is aimed upward is as one that is aimed down.
    CHECK(factor_of_tilt(half, 120) == Approx(0.75));
    CHECK(factor_of_tilt(half, 180) == 1);
    const LampTilt whole{1, {20, 180}, {0.9, 0.5}};
    CHECK(factor_of_tilt(whole, 0) == 0.9);
    CHECK(factor_of_tilt(whole, 100) == Approx(0.7));
    CHECK(factor_of_tilt(whole, 180) == 0.5);
    CHECK(factor_of_tilt({1, {}, {}}, 50) == 1);
    CHECK(factor_of_tilt({1, {40}, {0.8}}, 10) == 0.8);
    CHECK(factor_of_tilt({1, {40}, {0.8}}, 170) == 0.8);
}

TEST_CASE("only a vertical lamp follows the aim of its luminaire", "[photometry]") {
    CHECK(LampTilt{1, {}, {}}.follows_aim());
    CHECK_FALSE(LampTilt{2, {}, {}}.follows_aim());
    CHECK_FALSE(LampTilt{3, {}, {}}.follows_aim());
}

}  // namespace candelabra
