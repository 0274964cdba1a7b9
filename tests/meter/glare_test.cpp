// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/glare.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

constexpr double per_degree = std::numbers::pi / 180;

/// A direction at the angle beta from the line of sight, alpha from the vertical.
Vec3 aside(double alpha, double beta) {
    const double a = alpha * per_degree, b = beta * per_degree;
    return {std::sin(b) * std::sin(a), std::sin(b) * std::cos(a), std::cos(b)};
}

const Sightline level{Vec3(0, 0, 1), Vec3(0, 1, 0)};

}  // namespace

TEST_CASE("Guth's index is that of the formula", "[meter]") {
    // Computed apart; the table of CIE 117 has 2.86, 7.00, 2.11 and 7.00.
    CHECK(guth_index(level, aside(0, 26.565)) == Approx(2.86016).epsilon(1e-4));
    CHECK(guth_index(level, aside(45, 54.7356)) == Approx(7.02975).epsilon(1e-4));
    CHECK(guth_index(level, aside(90, 45)) == Approx(2.04981).epsilon(1e-4));
    CHECK(guth_index(level, aside(0, 45)) == Approx(7.05933).epsilon(1e-4));
    CHECK(guth_index(level, level.ahead) == 1);
    CHECK(guth_index(level, aside(0, 89)) == 16);
    CHECK(guth_index(level, aside(0, 90.1)) == 0);
    // Below, glare counts more than above; at the side both meet.
    CHECK(guth_index(level, aside(150, 30)) < guth_index(level, aside(30, 30)));
    CHECK(guth_index(level, aside(90.1, 40)) ==
          Approx(guth_index(level, aside(89.9, 40))).epsilon(0.2));
}

TEST_CASE("the unified glare rating is that of its formula", "[meter]") {
    // Two panels of 0.6 m by 0.6 m before an observer, at 30 cd/m2.
    const double sources = 2000.0 * 2000 * 0.0151322 / (3.50253 * 3.50253) +
                           1500.0 * 1500 * 0.00614517 / (2.37306 * 2.37306);
    CHECK(unified_glare_rating(30, sources) == Approx(14.3154).epsilon(1e-4));
    CHECK(unified_glare_rating(30, 0) == 0);
    CHECK(unified_glare_rating(1e6, 1) == 0);
}

TEST_CASE("veils over roads are those of their formula", "[meter]") {
    const double down = per_degree;
    const Sightline driver{Vec3(0, -std::sin(down), std::cos(down)), Vec3(0, 1, 0)};
    // Three lamps of 1000 cd, 8 m high and 3 m aside, before an eye 1.5 m high.
    double veil = 0;
    for (const double ahead : {17.875, 42.875, 67.875}) {
        const Vec3 to(3, 6.5, ahead);
        const Vec3 direction = unit(to);
        veil += veil_factor(driver, direction) * 1000 * dot(direction, driver.ahead) / dot(to, to);
    }
    CHECK(veil == Approx(0.140536).epsilon(1e-4));
    CHECK(threshold_increment(veil, 1) == Approx(9.13485).epsilon(1e-4));
    CHECK(threshold_increment(0.5, 5.001) == Approx(threshold_increment(0.5, 5)).epsilon(0.03));
    CHECK(veil_factor(driver, driver.ahead) == 0);
    CHECK(veil_factor(level, aside(90, 61)) == 0);
    CHECK(veil_factor(level, aside(0, 20.1)) == 0);
    CHECK(veil_factor(level, aside(0, 19.9)) > 0);
    CHECK(veil_factor(level, aside(180, 40)) > 0);
}

}  // namespace candelabra
