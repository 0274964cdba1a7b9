// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/draw.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

TEST_CASE("a point knows the clear solids that it is in", "[world]") {
    const SharedWorld world =
        world_of("sphere { 0, 2 pigment { rgbt 1 } } sphere { 0, 3 pigment { rgb 1 } }");
    CHECK(world->containing(Vec3(1, 0, 0)).size() == 1);
    CHECK(world->containing(Vec3(2.5, 0, 0)).empty());
    // With fog, it also finds the others, which keep fog out, unless they are hollow.
    const SharedWorld foggy = world_of(
        "fog { distance 9 rgb 1 } sphere { 0, 2 hollow } sphere { 0, 3 } sphere { 0, 4 hollow }"
        "union { sphere { 0, 5 } sphere { 9*x, 2 } } difference { sphere { 0, 6 } box { 1, 9 } }");
    CHECK(foggy->containing(Vec3(1, 0, 0)).size() == 3);
    // Rays of a parallel camera begin in many places, so the world has an index. Other cameras are
    // at one place, so the world has none.
    const std::string scene = R"(
        #for (I, 1, 20) sphere { 10*I*x, 3 pigment { rgbt 1 } } #end
        plane { y, -5 pigment { rgbt 1 } } sphere { 0, 3 pigment { rgb 1 } }
        difference { box { -3, 3 } sphere { 0, 3 } pigment { rgbt 1 } }
        sphere { 40*z, 5 inverse pigment { rgbt 1 } } disc { -30*z, y, 5 pigment { rgbt 1 } }
        height_field { function 8, 8 { x*y } scale 9 translate 50*x pigment { rgbt 1 } }
        box { 20, 30 pigment { rgbt 1 } rotate 20 } torus { 9, 2 inverse pigment { rgbt 1 } }
        merge { sphere { -20*x, 3 } box { -24, -20 } inverse pigment { rgbt 1 } })";
    const SharedWorld parallel =
                          world_of("camera { orthographic location -9*z look_at 0 }" + scene),
                      other = world_of("camera { location -9*z look_at 0 }" + scene);
    Draw draw(3);
    for (int i = 0; i < 3000; ++i) {
        const Vec3 point = draw.point(60);
        EnteredSolids found = parallel->containing(point), expected = other->containing(point);
        std::ranges::sort(found);
        std::ranges::sort(expected);
        CAPTURE(point.x, point.y, point.z);
        CHECK(found == expected);
    }
    CHECK(parallel->geometry.clear_solids.finite.size() > 20);
}

TEST_CASE("a ray enters and leaves solids where it passes their surfaces", "[world]") {
    const SharedWorld world = world_of(
        "sphere { 0, 2 } sphere { x, 2 } union { sphere { 0, 5 } sphere { 9*x, 2 } interior { } }");
    EnteredSolids inside;
    CHECK(world->pass(0, inside) == Passing::enters);
    CHECK(world->pass(1, inside) == Passing::enters);
    CHECK(world->pass(0, inside) == Passing::leaves_outer);
    CHECK(world->pass(1, inside) == Passing::leaves_innermost);
    CHECK(inside.empty());
    // Parts of a union that share an interior are one solid.
    CHECK(world->pass(2, inside) == Passing::enters);
    CHECK(world->pass(3, inside) == Passing::leaves_innermost);
}

}  // namespace candelabra
