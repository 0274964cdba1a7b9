// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/julia_formula.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

JuliaFractal fractal(int function, int max_iteration) {
    JuliaFractal result;
    result.parameter = Vec4(0);
    result.algebra = hypercomplex_numbers;
    result.function = function;
    result.max_iteration = max_iteration;
    return result;
}

/// Expected values are those of POV-Ray's trace().
void slopes_along(const JuliaFractal& julia, const Vec3& p, const Vec3& expected) {
    const Vec3 slope = unit(formula_slope(JuliaSet(julia), p));
    for (int axis = 0; axis < 3; ++axis) CHECK(slope[axis] == Approx(expected[axis]).margin(1e-3));
}

}  // namespace

TEST_CASE("which functions are formulas", "[shape]") {
    CHECK(is_by_formula(fractal(julia_sin, 2)));
    CHECK_FALSE(is_by_formula(fractal(julia_cube, 2)));
    JuliaFractal power = fractal(julia_sqr, 2);
    power.exponent = Vec2(2, 0);
    CHECK(function_of(power) == julia_pwr);
    CHECK(is_by_formula(power));
}

TEST_CASE("an orbit under a formula counts from where y stands for z", "[shape]") {
    CHECK(formula_place(fractal(julia_exp, 2), Vec3(1, 2, 3)) == Vec3(1, 2, 2));
    CHECK(formula_place(fractal(julia_reciprocal, 2), Vec3(1, 2, 3)) == Vec3(1, 2, 3));
    const JuliaFractal sine = fractal(julia_sin, 2);
    const JuliaSet set(sine);
    CHECK(julia_orbit(set, Vec3(0, 0, 2.1)).stays == false);
    CHECK(julia_contains(set, Vec3(0, 0, 2.1)));
    CHECK(formula_image(sine, Vec4(0.5, 0, 0, 0)).x == Approx(std::sin(0.5)));
}

TEST_CASE("slopes of formulas are POV-Ray's", "[shape]") {
    slopes_along(fractal(julia_exp, 2), Vec3(1.386294, 0.1, 0.8),
                 Vec3(0.99562060, -0.06610457, -0.06610457));
    JuliaFractal power = fractal(julia_sqr, 2);
    power.exponent = Vec2(2, 0);
    slopes_along(power, Vec3(-1.9796, 0.2, 0.8), Vec3(-0.98830703, -0.10781747, -0.10781747));
    slopes_along(fractal(julia_reciprocal, 2), Vec3(-0.178913007, 0.1, 0.2),
                 Vec3(0.313291839, -0.590561696, -0.743696919));
    // After the counted orbit escapes, the other one is used.
    slopes_along(fractal(julia_sin, 2), Vec3(1.3, 1.97757, 0.2), Vec3(0.655, 0.534, 0.534));
}

}  // namespace candelabra
