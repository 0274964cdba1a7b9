// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/cameras.h"

#include "evaluate/script.h"

#include <catch2/catch.hpp>

TEST_CASE("a camera has its type and its words", "[evaluate]") {
    const Script done =
        run("#version 3.7; camera { orthographic location <1, 2, 3> look_at 0 angle 30 right 2*x "
            "translate x }");
    REQUIRE(done.text.empty());
    CHECK(std::holds_alternative<Orthographic>(done.scene.camera));
    CHECK(done.view().location == Vec3(1, 2, 3));
    CHECK(done.view().look_at == Vec3(0));
    CHECK(done.view().angle == 30);
    CHECK_FALSE(done.view().up);
    CHECK(done.view().transform.point(Vec3(0)) == Vec3(1, 0, 0));
    CHECK(std::holds_alternative<Perspective>(
        run("#version 3.7; camera { location 1 }").scene.camera));
}

TEST_CASE("cameras are declared, and have a default", "[evaluate]") {
    const Script done = run(
        "#version 3.7; #declare C = camera { orthographic location y } camera { C translate x }");
    REQUIRE(done.text.empty());
    CHECK(std::holds_alternative<Orthographic>(done.scene.camera));
    CHECK(done.view().transform.point(Vec3(0)) == Vec3(1, 0, 0));
    CHECK(run("#version 3.7; #default { camera { location y } } camera { orthographic }")
              .view()
              .location == Vec3(0, 1, 0));
    CHECK(run("#version 3.7; #default { camera { location y } }").view().location == Vec3(0, 1, 0));
}

TEST_CASE("of several cameras the last one counts", "[evaluate]") {
    const Script done = run("#version 3.7; camera { location x } camera { location y }");
    REQUIRE(done.said.size() == 1);
    CHECK(done.said[0].fault == Fault::duplicate);
    CHECK(done.view().location == Vec3(0, 1, 0));
}

TEST_CASE("wrong cameras are told of once", "[evaluate]") {
    CHECK(complaint("camera { location x look_at x }") ==
          "error degenerate: `look_at` must not be the camera's own location");
    CHECK(complaint("camera { location x orthographic }") ==
          "error misplaced: the type `orthographic` must come first in `camera`");
    CHECK(complaint("camera { perspective angle 180 }") ==
          "error degenerate: `angle` of a flat picture must be below 180 degrees");
    CHECK(complaint("camera { cylinder 5 }") ==
          "error out-of-range: `type` of `camera` must be from 1 to 4, but it is 5");
    CHECK(complaint("camera { locaton x }") ==
          "error unknown-word: `camera` has no word `locaton`");
    CHECK(complaint("camera { look_at \"here\" }") ==
          "error wrong-type: `look_at` of `camera` must be a vector of 3, but it is a string");
}
