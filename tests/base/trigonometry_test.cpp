// SPDX-License-Identifier: GPL-3.0-or-later
// elementary_test.cpp pins the bits of these functions.
#include "base/elementary.h"

#include "support/elementary.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace candelabra {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("functions of angles are exact to about a unit", "[elementary]") {
    using L = long double;
    for (const double reach : {0.1, 0.8, 7.0, 1e3, 1e6, 1e12}) {
        INFO(reach);
        CHECK(worst_error(
                  math::sin, [](L x) { return std::sin(x); }, -reach, reach) < 0.9);
        CHECK(worst_error(
                  math::cos, [](L x) { return std::cos(x); }, -reach, reach) < 0.9);
        CHECK(worst_error(
                  math::tan, [](L x) { return std::tan(x); }, -reach, reach) < 1);
    }
    CHECK(worst_error(
              math::asin, [](L x) { return std::asin(x); }, -1, 1) < 0.9);
    CHECK(worst_error(
              math::acos, [](L x) { return std::acos(x); }, -1, 1) < 0.9);
    CHECK(worst_error(
              math::acos, [](L x) { return std::acos(x); }, 0.999, 1) < 0.9);
    CHECK(worst_error(
              math::atan, [](L x) { return std::atan(x); }, -1, 1) < 1);
    CHECK(worst_error(
              math::atan, [](L x) { return std::atan(x); }, -1e3, 1e3) < 1);
    const auto angle = [](L y, L x) { return std::atan2(y, x); };
    CHECK(worst_error(math::atan2, angle, {-1, 1}, {-1, 1}) < 1.4);
    CHECK(worst_error(math::atan2, angle, {-1e-3, 1e-3}, {-1, 1}) < 1.4);
    CHECK(worst_error(math::atan2, angle, {-1e-300, 1e-300}, {-1e-301, 1e-299}) < 1.4);
    CHECK(worst_error(math::atan2, angle, {-1e307, 1e307}, {-1e307, 1e307}) < 1.4);
}

TEST_CASE("huge angles, and angles close to a multiple of a quarter turn, count exactly",
          "[elementary]") {
    double worst = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const double any = std::bit_cast<double>(mix(i));
        const double close = std::round(static_cast<double>(mix(~i) >> 40)) * (pi / 2);
        for (const double x : {any, close}) {
            if (!std::isfinite(x)) continue;
            worst = std::max(worst,
                             error_in_units(math::sin(x), std::sin(static_cast<long double>(x))));
            worst = std::max(worst,
                             error_in_units(math::cos(x), std::cos(static_cast<long double>(x))));
        }
    }
    CHECK(worst < 0.95);
    // The number that comes closest to a multiple of pi/2, according to Kahan.
    CHECK(math::cos(std::ldexp(6381956970095103.0, 797)) == Approx(-4.68716592425462761e-19));
}

TEST_CASE("both functions of one angle are those of it alone", "[elementary]") {
    for (const double x : {0.0, 0.3, -0.9, 2.0, 3.0, -4.0, 1e4, -1e30}) {
        const math::SineCosine both = math::sin_cos(x);
        CHECK((both.sine == math::sin(x) && both.cosine == math::cos(x)));
    }
}

TEST_CASE("special values of functions of angles are those of ISO C", "[elementary]") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto values = {0.0,       -0.0,   1.0,   -1.0,   0.5,      -3.0,      4.9e-324,
                         -4.9e-324, 1e-310, 1e300, -1e308, infinite, -infinite, none};
    for (const double x : values) {
        INFO(x);
        CHECK(agree(math::sin(x), std::sin(x)));
        CHECK(agree(math::cos(x), std::cos(x)));
        CHECK(agree(math::tan(x), std::tan(x)));
        CHECK(agree(math::asin(x), std::asin(x)));
        CHECK(agree(math::acos(x), std::acos(x)));
        CHECK(agree(math::atan(x), std::atan(x)));
        for (const double y : values) {
            INFO(y);
            CHECK(agree(math::atan2(y, x), std::atan2(y, x)));
        }
    }
}

}  // namespace candelabra
