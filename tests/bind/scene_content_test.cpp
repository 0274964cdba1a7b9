// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/scene_content.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("an object without a texture gets the default one at its end", "[bind]") {
    const Script done =
        run("#version 3.7; sphere { 0, 1 } #default { pigment { rgb <1, 0, 0> } } sphere { x, 1 } "
            "sphere { y, 1 pigment { rgb 1 } }");
    REQUIRE(done.scene.objects.size() == 3);
    CHECK(done.texture(0).pigment.colour.rgb == Rgb(0));
    CHECK(done.texture(1).pigment.colour.rgb == Rgb(1, 0, 0));
    CHECK(done.texture(2).pigment.colour.rgb == Rgb(1));
}

TEST_CASE("lights leave the objects that they stand in", "[bind]") {
    const Script done =
        run("#version 3.7; #declare L = light_source { y, 1 } object { L } "
            "light_source { 2*y, 1 looks_like { sphere { 0, 1 } } }");
    CHECK(done.scene.lights.size() == 2);
    CHECK(done.scene.objects.size() == 1);
}

TEST_CASE("the last camera counts", "[bind]") {
    const Script done = run("#version 3.7; camera { location x } camera { location <0, 0, -7> }");
    REQUIRE(done.said.size() == 1);
    CHECK(done.said[0].fault == Fault::duplicate);
    CHECK(done.scene.camera_given);
    CHECK(done.view().location == Vec3(0, 0, -7));
}

}  // namespace candelabra
