// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/sor.h"

#include "support/axes.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::vector<Vec2> sor_points = {{0.5, -1}, {1, 0}, {0.5, 1}, {1, 2}, {0.2, 3}};

}  // namespace

TEST_CASE("a sor is met where POV-Ray meets it", "[shape]") {
    const BuiltSor vase = build({sor_points, false});
    const auto lower = hits(vase, {Vec3(-5, 0.5, 0), x}), upper = hits(vase, {Vec3(-5, 1.5, 0), x});
    REQUIRE(lower.size() == 2);
    CHECK(lower[0].t == Approx(5 - 0.7906).margin(1e-4));
    CHECK(length(lower[0].normal - Vec3(-0.8148, 0.5797, 0)) < 1e-4);
    REQUIRE(upper.size() == 2);
    CHECK(upper[0].t == Approx(5 - 0.8139).margin(1e-4));
    CHECK(length(upper[0].normal - Vec3(-0.8049, -0.5934, 0)) < 1e-4);
    CHECK(answers(vase, {{Vec3(0.2, 5, 0), -y}, {{3, y, true}, {5, -y, false}}}));
    CHECK(bounds(vase).high.x == Approx(1.0041).margin(1e-4));
    CHECK(bounds(vase).low.y == 0);
    CHECK(bounds(vase).high.y == 2);
}

TEST_CASE("an open sor has no ends, but the same inside", "[shape]") {
    const BuiltSor tube = build({sor_points, true});
    CHECK(hits(tube, {Vec3(0.2, 5, 0.1), -y}).empty());
    CHECK(inside(tube, Vec3(0, 0.5, 0)));
    CHECK_FALSE(inside(tube, Vec3(0.8, 0.5, 0)));
    CHECK_FALSE(inside(tube, Vec3(0, 2.1, 0)));
}

TEST_CASE("what can be wrong with a sor is said", "[shape]") {
    CHECK(problem(Sor{sor_points, false}).empty());
    CHECK(problem(Sor{{{1, 0}, {1, 1}, {1, 2}}, false}) == "a `sor` needs at least 4 points");
    CHECK(problem(Sor{{{1, 0}, {-1, 1}, {1, 2}, {1, 3}}, false}) ==
          "a `sor` needs radii that are not below 0");
    CHECK(problem(Sor{{{1, 0}, {1, 2}, {1, 1}, {1, 3}}, false}) ==
          "a `sor` needs heights that rise from point to point");
    CHECK(problem(Sor{{{1, 1}, {1, 0}, {1, 1}, {1, 3}}, false}) ==
          "a `sor` needs heights that rise from point to point");
    CHECK(problem(Sor{{{0, 0}, {0, 1}, {0, 2}, {0, 3}}, false}) ==
          "a `sor` needs a radius above 0");
}

}  // namespace candelabra
