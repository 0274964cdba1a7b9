// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/sight.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a tried ray sees what is first, and whether light passes it", "[transport]") {
    const SharedWorld world = world_of(R"(#version 3.7;
        sphere { 5*z, 1 pigment { rgbt 1 } }
        sphere { 9*z, 1 pigment { rgb 1 } finish { emission 2 } })");
    const auto glass = first_sight(*world, {Vec3(0), Vec3(0, 0, 1)}, 0);
    REQUIRE(glass);
    CHECK(glass->distance == Approx(4));
    CHECK(glass->passes == Approx(1));
    CHECK_FALSE(glass->light);
    const auto lamp = first_sight(*world, {Vec3(0, 0, 7), Vec3(0, 0, 1)}, 0);
    REQUIRE(lamp);
    CHECK(lamp->light);
    CHECK(lamp->luminance == Approx(2));
    CHECK(lamp->passes == 0);
    CHECK_FALSE(first_sight(*world, {Vec3(0), Vec3(0, 1, 0)}, 0));
}

}  // namespace candelabra
