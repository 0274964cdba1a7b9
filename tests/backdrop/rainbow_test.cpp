// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/rainbow.h"

#include "support/rgb.h"

#include <catch2/catch.hpp>

#include <limits>
#include <numbers>

namespace candelabra {

namespace {

/// A band of one colour from 39 to 45 degrees around z.
Rainbow band() {
    Rainbow bow;
    bow.direction = Vec3(0, 0, 2);
    bow.angle = 42;
    bow.width = 6;
    bow.map = {{0, {Rgb(1, 0, 0)}}, {1, {Rgb(0, 0, 1)}}};
    return bow;
}

/// Radiance over black at an angle from z, turned away from y by `turned` degrees.
Rgb seen(const Rainbow& bow, double degrees, double turned = 0, double chance = 0.5) {
    const double angle = degrees * std::numbers::pi / 180, turn = turned * std::numbers::pi / 180;
    const Ray ray{Vec3(0), Vec3(std::sin(angle) * std::sin(turn), std::sin(angle) * std::cos(turn),
                                std::cos(angle))};
    return veil_of(std::span(&bow, 1), ray, std::numeric_limits<double>::infinity(), chance).added;
}

bool near(const Rgb& a, const Rgb& b) { return length(a - b) < 1e-6; }

}  // namespace

TEST_CASE("a rainbow is a band around its direction", "[backdrop]") {
    const Rainbow bow = band();
    CHECK(near(seen(bow, 38.9), Rgb(0)));
    CHECK(near(seen(bow, 39.6), Rgb(0.9, 0, 0.1)));
    CHECK(near(seen(bow, 42), Rgb(0.5, 0, 0.5)));
    CHECK(near(seen(bow, 45.1), Rgb(0)));
    CHECK(near(seen(bow, 138), Rgb(0)));
}

TEST_CASE("an arc fades towards its ends", "[backdrop]") {
    Rainbow bow = band();
    bow.arc_angle = 120;
    bow.falloff_angle = 60;
    CHECK(seen(bow, 42, 29).r == Approx(0.5));
    CHECK(seen(bow, 42, 45).r == Approx(0.25));
    CHECK(seen(bow, 42, -45).r == Approx(0.25));
    CHECK(seen(bow, 42, 61).r == 0);
}

TEST_CASE("jitter mixes colours, distance and transmit thin the band", "[backdrop]") {
    Rainbow bow = band();
    bow.jitter = 0.1;
    CHECK(near(seen(bow, 42, 0, 0), Rgb(0.6, 0, 0.4)));
    CHECK(near(seen(bow, 42, 0, 1), Rgb(0.4, 0, 0.6)));
    bow.jitter = 0;
    bow.distance = 10;
    const Ray ray{Vec3(0), Vec3(0, std::sin(42 * std::numbers::pi / 180),
                                std::cos(42 * std::numbers::pi / 180))};
    CHECK(veil_of(std::span(&bow, 1), ray, 10, 0.5).through(Rgb(1)).g == Approx(std::exp(-1)));
    CHECK(veil_of(std::span(&bow, 1), ray, 0, 0.5).through(Rgb(1)).g == 1);
}

}  // namespace candelabra
