// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/built_shape.h"

#include <catch2/catch.hpp>

TEST_CASE("a built shape answers rays as its kind does", "[shape]") {
    const Sphere sphere{Vec3(1, 0, 0), 2};
    const BuiltShape ready = built(Shape(sphere));
    REQUIRE(std::get_if<Sphere>(&ready));
    CHECK(bounds(ready).low == Vec3(-1, -2, -2));
    CHECK(inside(ready, Vec3(2.5, 0, 0)));
    CHECK_FALSE(inside(ready, Vec3(-1.5, 0, 0)));
    Crossings found;
    crossings(ready, {Vec3(-5, 0, 0), Vec3(1, 0, 0)}, found);
    CHECK(found.size() == 2);
}

TEST_CASE("the box of the inside of a plane is a half space, that of its surface is all",
          "[shape]") {
    const BuiltShape ground = built(Shape(Plane{Vec3(0, 1, 0), 0}));
    CHECK(inside_bounds(ground).high.y <= 1e-6);
    CHECK(inside_bounds(ground).low.x == -std::numeric_limits<double>::infinity());
}
