// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/operation.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

namespace candelabra {

TEST_CASE("functions of one argument have numbers", "[formula]") {
    REQUIRE(function_number("sin"));
    CHECK(apply_function(*function_number("sin"), 0.5) == std::sin(0.5));
    CHECK(apply_function(*function_number("degrees"), 0) == 0);
    CHECK(apply_function(*function_number("int"), -2.9) == -2);
    CHECK(std::isnan(apply_function(*function_number("sqrt"), -1)));
    CHECK_FALSE(function_number("vlength"));
    CHECK_FALSE(function_number("rand"));
    CHECK(operation_of_two("pow") == Operation::power);
    CHECK_FALSE(operation_of_two("min"));
}

TEST_CASE("numbers that are close count as equal, and as 0", "[formula]") {
    const double infinite = std::numeric_limits<double>::infinity();
    CHECK(about(1, 1 + 0.9 * tolerance));
    CHECK(!about(1, 1 + 2 * tolerance));
    CHECK(about(infinite, infinite));
    CHECK(!about(infinite, -infinite));
    CHECK(about(std::nan(""), 1));
    CHECK(is_true(-2 * tolerance));
    CHECK(!is_true(tolerance));
    CHECK(!is_true(std::nan("")));
}

TEST_CASE("whole numbers have 32 bits", "[formula]") {
    CHECK(to_int32(2.9) == 2);
    CHECK(to_int32(-2.9) == -2);
    CHECK(to_int32(2147483647.5) == 2147483647);
    CHECK(to_int32(2147483648.0) == INT32_MIN);
    CHECK(to_int32(std::nan("")) == INT32_MIN);
    CHECK(to_int32(-INFINITY) == INT32_MIN);
}

TEST_CASE("the remainder is that of the library, to the last bit", "[formula]") {
    const auto same = [](double a, double b) {
        INFO(a << " mod " << b);
        const double ours = remainder_of(a, b), theirs = std::fmod(a, b);
        CHECK((ours == theirs || (std::isnan(ours) && std::isnan(theirs))));
        CHECK((std::isnan(ours) || std::signbit(ours) == std::signbit(theirs)));
    };
    const double edges[] = {0,
                            -0.0,
                            1,
                            -1,
                            2,
                            3,
                            -7,
                            10,
                            0.5,
                            1e15,
                            4503599627370495.0,
                            4503599627370497.0,
                            1e300,
                            INFINITY,
                            NAN,
                            1e-300};
    for (const double a : edges)
        for (const double b : edges) same(a, b);
    std::mt19937_64 random(5);
    for (int i = 0; i < 20000; ++i) {
        const double a = static_cast<double>(random() >> (random() % 60 + 4));
        const double b = static_cast<double>(random() >> (random() % 60 + 4));
        same(a, b);
        same(-a, b);
        same(a / 8, b);
    }
}

}  // namespace candelabra
