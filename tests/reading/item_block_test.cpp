// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/item_block.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a scene has meters", "[reading]") {
    const Scene scene = scene_of(
        "#version 3.7; meter { \"desk\" corner -x along 2*x across <0, 0, 3> en_12464 maintenance "
        "0.8 } meter { ugr points { 2, <0, 1.2, 0>, <1, 1.2, 0> } direction -z } meter { luminance "
        "eye -60*z corner <0, 0, 0> along 35*z across 7*x en_13201 lanes 2 }");
    REQUIRE(scene.meters.size() == 3);
    CHECK(scene.meters[0].name == "desk");
    CHECK(scene.meters[0].corner == Vec3(-1, 0, 0));
    CHECK(scene.meters[0].maintenance == 0.8);
    CHECK(scene.meters[1].measures() == Quantity::ugr);
    CHECK(scene.meters[1].points.size() == 2);
    CHECK(scene.meters[1].direction == Vec3(0, 0, -1));
    CHECK(scene.meters[2].eye == Vec3(0, 0, -60));
    CHECK(scene.meters[2].lanes == 2);
    CHECK(scene.meters[2].rule == static_cast<int>(GridRule::en_13201));
}

TEST_CASE("the word meter is no reserved word", "[reading]") {
    CHECK(scene_of("#version 3.7; #declare meter = 2; sphere { 0, meter }").objects.size() == 1);
    const Evaluated wrong = evaluated("#version 3.7; meter { ugr points { 1, <0, 0, 0> } }");
    CHECK(wrong.failed);
    CHECK(wrong.diagnostics.find("`ugr` of `meter` needs `direction`") != std::string::npos);
    CHECK(wrong.diagnostics.find("help: meter { \"desk\" corner <-1, 0.8, -1> along 2*x") !=
          std::string::npos);
    CHECK(evaluated("#version 3.7; meter { sphere { 0, 1 } }").failed);
    CHECK(evaluated("#version 3.7; meter { \"a\" corner <0, 0, 0> }").failed);
}

}  // namespace candelabra
