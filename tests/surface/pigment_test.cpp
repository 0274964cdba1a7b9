// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pigment.h"

#include <catch2/catch.hpp>

TEST_CASE("a pattern is looked up in the space before the pigment's transform", "[surface]") {
    Pigment pigment;
    pigment.pattern = Gradient{Vec3(1, 0, 0)};
    pigment.map = default_map(*pigment.pattern);
    pigment.transform = Transform::scaling(Vec3(2));
    CHECK(evaluate(pigment, Vec3(0.5, 7, 7)).rgb.x == Approx(0.25));
}

TEST_CASE("brightest and transparent look at the whole map", "[surface]") {
    Pigment plain;
    plain.colour = {Vec3(0.5, 2, 0)};
    CHECK(brightest(plain) == Vec3(0.5, 2, 0));
    CHECK_FALSE(transparent(plain));

    Pigment mixed;
    mixed.pattern = Checker{};
    mixed.map = {{0, {Vec3(1, 0, 0)}}, {1, {Vec3(0, 3, 0), 0, 0.5}}};
    CHECK(brightest(mixed) == Vec3(1, 3, 0));
    CHECK(transparent(mixed));
}

TEST_CASE("the default maps are POV-Ray's", "[surface]") {
    CHECK(default_map(Pattern(Checker{})).back().colour.rgb == Vec3(0, 1, 0));
    CHECK(default_map(Pattern(Gradient{})).back().colour.rgb == Vec3(1));
}
