// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/flatten.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

TEST_CASE("children inherit what they do not say", "[world]") {
    const World world = world_of(R"(
        union {
            sphere { 0, 1 }
            sphere { 5, 1 pigment { rgb 0.5 } }
            pigment { rgb 0.25 }
            no_shadow
        }
    )");
    REQUIRE(world.spheres.size() == 2);
    CHECK(world.material(0).texture->pigment.colour.rgb.x == 0.25);
    CHECK(world.material(1).texture->pigment.colour.rgb.x == 0.5);
    CHECK(world.material(1).no_shadow);
}

TEST_CASE("textures move with the unions around them", "[world]") {
    const World world = world_of(R"(
        union {
            sphere { 0, 1 pigment { gradient x } }
            translate 10.25*x
        }
    )");
    CHECK(evaluate(world.material(0).texture->pigment, Vec3(10.5, 0, 0)).rgb.x == Approx(0.25));
}

TEST_CASE("many copies of an object share their looks", "[world]") {
    const World world = world_of(R"(
        #declare Lamp = union { sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } } cylinder { 0, y, 0.1 pigment { rgb 0 } } }
        #for (I, 1, 100) object { Lamp translate 3*I*x } #end
    )");
    CHECK(world.objects == 200);
    CHECK(world.materials.size() == 2);
    CHECK(world.luminaires.size() == 100);
}

TEST_CASE("a luminaire that cannot light says so", "[world]") {
    Diagnostics diagnostics;
    const Scene scene = scene_of("plane { y, 0 pigment { rgb 1 } finish { emission 1 } }");
    compile(scene, {}, diagnostics);
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all()[0].severity == Severity::warning);
}
