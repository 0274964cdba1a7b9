// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/rgb.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Rgb between(const World& world, const Vec3& from, const Vec3& to) {
    return world.transmittance({from, unit(to - from)}, 0, length(to - from));
}

}  // namespace

TEST_CASE("light passes through what is clear, and counts each surface once", "[world]") {
    const SharedWorld world = world_of(R"(
        sphere { <0, 0, 5>, 1 pigment { rgbf <1, 0.5, 0.25, 0.5> } }
        box { <9, -1, 4>, <11, 1, 5> pigment { rgb 1 } }
        box { <-11, -1, 4>, <-9, 1, 5> pigment { rgb 1 } no_shadow }
    )");
    const Rgb passed = between(*world, Vec3(0), Vec3(0, 0, 20));
    CHECK(length(passed - Rgb(0.25, 0.0625, 0.015625)) < 1e-12);
    CHECK(between(*world, Vec3(0), Vec3(0, 0, 5)).r == Approx(0.5));
    CHECK(between(*world, Vec3(10, 0, 0), Vec3(10, 0, 20)) == Rgb(0));
    CHECK(between(*world, Vec3(10, 0, 0), Vec3(10, 0, 4)) == Rgb(1));
    CHECK(between(*world, Vec3(-10, 0, 0), Vec3(-10, 0, 20)) == Rgb(1));
}

}  // namespace candelabra
