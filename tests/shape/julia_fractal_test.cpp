// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/julia_fractal.h"

#include "support/hits.h"

#include <catch2/catch.hpp>

TEST_CASE("a julia fractal without a constant is a ball", "[shape]") {
    JuliaFractal ball;
    ball.parameter = Vec4(0);
    const Vec3 z(0, 0, 1);
    const auto found = hits(ball, {-5.0 * z, z});
    REQUIRE(found.size() == 2);
    CHECK(found[0].t == Approx(4).margin(1e-5));
    CHECK(length(found[0].normal + z) < 1e-5);
}

TEST_CASE("what is wrong with a julia fractal", "[shape]") {
    JuliaFractal julia;
    julia.function = julia_sin;
    CHECK(problem(julia) == "a `julia_fractal` of quaternions has `sqr` and `cube` only");
    julia.algebra = hypercomplex_numbers;
    CHECK(problem(julia).empty());
    julia.slice = Vec4(1, 0, 0, 0);
    CHECK_FALSE(problem(julia).empty());
}
