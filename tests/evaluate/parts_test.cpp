// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/parts.h"

#include "evaluate/script.h"

#include <catch2/catch.hpp>

TEST_CASE("parts of a shape come in blocks of their own", "[evaluate]") {
    const Script done = run(R"(#version 3.7;
        blob { threshold 0.5 sphere { x, 2, 3 } cylinder { 0, y, 1, strength 2 }
               component 1 2 <0, 0, 3> })");
    CHECK(done.text.empty());
    const Blob& blob = *done.shape<Shared<Blob>>();
    REQUIRE(blob.spheres.size() == 1);
    CHECK(blob.spheres[0].radius == 2);
    CHECK(blob.spheres[0].strength == 3);
    REQUIRE(blob.cylinders.size() == 1);
    CHECK(blob.cylinders[0].cap == Vec3(0, 1, 0));
    REQUIRE(blob.components.size() == 1);
    CHECK(blob.components[0].centre == Vec3(0, 0, 3));
}

TEST_CASE("what is wrong in a part is told of once", "[evaluate]") {
    CHECK(complaint("blob { sphere { 0 } }").starts_with("error"));
    CHECK(complaint("blob { sphere { 0, 1, 1 radius 2 } }").starts_with("error"));
}
