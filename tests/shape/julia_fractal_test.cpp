// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/julia_fractal.h"

#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

#include <utility>

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

TEST_CASE("a ray finds the same crossings whatever part of it is asked for", "[shape]") {
    JuliaFractal julia;
    julia.parameter = Vec4(-0.083, 0, -0.83, -0.025);
    julia.max_iteration = 2;
    julia.precision = 3;
    const auto ways = {std::pair{quaternions, julia_sqr}, {hypercomplex_numbers, julia_cosh}};
    for (const auto& [algebra, function] : ways) {
        julia.algebra = algebra;
        julia.function = function;
        Draw draw(3);
        int found = 0;
        for (int i = 0; i < 500; ++i) {
            const Ray ray{draw.point(2), unit(draw.point(1))};
            Crossings first, again;
            nearest_crossings(julia, ray, {1e-10, 100}, first);
            if (first.size() == 0 || !(first[first.size() - 1].t > 1e-3)) continue;
            ++found;
            const double t = first[first.size() - 1].t;
            nearest_crossings(julia, ray, {t * (1 - 1e-9), 100}, again);
            REQUIRE(again.size() > 0);
            CHECK(again[again.size() - 1].t == t);
        }
        CHECK(found > 100);
    }
}

}  // namespace candelabra
