// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/enclosed_function.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

TEST_CASE("functions on intervals hold their values and slopes", "[formula]") {
    const std::string name =
        GENERATE(as<std::string>(), "abs", "acos", "acosh", "asin", "asinh", "atan", "atanh",
                 "ceil", "cos", "cosh", "degrees", "exp", "floor", "int", "ln", "log", "radians",
                 "sin", "sinh", "sqrt", "tan", "tanh");
    INFO(name);
    const std::uint16_t number = *function_number(name);
    Draw draw(7);
    int known = 0;
    for (int i = 0; i < 500; ++i) {
        const double low = draw.between(-4, 4), size = std::pow(10, draw.between(-4, 0.7));
        const double speed = draw.between(-2, 2);
        const Enclosure result = enclosed_function(number, {{low, low + size}, {speed, speed}});
        known += result.slope != all_numbers;
        double before = NAN;
        for (int k = 0; k <= 20; ++k) {
            const double value = apply_function(number, low + size * k / 20);
            const double slack = 1e-9 * (1 + std::abs(value));
            if (std::isfinite(value))
                CHECK((value >= result.value.low - slack && value <= result.value.high + slack));
            // By the mean value theorem, the mean slope between two arguments occurs somewhere
            // between them.
            const double slope = (value - before) / (size / 20) * speed;
            if (std::isfinite(slope))
                CHECK((slope >= result.slope.low - 1e-4 * (1 + std::abs(slope)) &&
                       slope <= result.slope.high + 1e-4 * (1 + std::abs(slope))));
            before = value;
        }
    }
    CHECK(known > 30);
}

TEST_CASE("beyond 32 bits the bounds of an integer part are unknown", "[formula]") {
    const std::uint16_t number = *function_number("int");
    for (const Bounds& range : {Bounds{2e9, 3e9}, Bounds{-3e9, -2e9}, Bounds{3e9, 4e9}})
        CHECK(enclosed_function(number, {range, {1, 1}}) == Enclosure::unknown());
    CHECK(enclosed_function(number, {{1.5, 2.5}, {1, 1}}).value == Bounds{1, 2});
}

}  // namespace candelabra
