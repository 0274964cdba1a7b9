// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/julia_fractal.h"

#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

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

TEST_CASE("the nearest crossing of a julia fractal is the first of all", "[shape]") {
    JuliaFractal julia;
    julia.parameter = Vec4(-0.083, 0, -0.83, -0.025);
    julia.max_iteration = 8;
    Draw draw(2);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        const Ray ray{draw.point(3), unit(draw.point(1))};
        Crossings nearest;
        nearest_crossings(julia, ray, {-100, 100}, nearest);
        const auto all = hits(julia, ray);
        REQUIRE(nearest.size() == (all.empty() ? 0 : 1));
        if (all.empty()) continue;
        ++found;
        CHECK(nearest[0].t == Approx(all[0].t).margin(1e-9));
        CHECK(nearest[0].entering == all[0].entering);
    }
    CHECK(found > 20);
}

}  // namespace candelabra
