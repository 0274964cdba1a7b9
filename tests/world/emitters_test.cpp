// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/emitters.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("primitives of each kind become luminaires", "[world]") {
    const World world = world_of(R"(#version 3.7;
        #default { pigment { rgb 1 } finish { emission 2 } }
        torus { 2, 0.5 }
        difference { box { 0, 1 } sphere { 0, 0.5 } }
        triangle { 0, x, y }
        sphere { 5, 1 }
        superellipsoid { <0.5, 0.5> translate 9*x }
    )");
    CHECK(world.lights.luminaires.size() == 6);
    const auto made = [&](auto kind) {
        return std::ranges::count_if(world.lights.luminaires, [](const Luminaire& each) {
            return std::holds_alternative<decltype(kind)>(each.emitter);
        });
    };
    CHECK(made(SphereEmitter()) == 1);
    CHECK(made(TriangleEmitter()) == 1);
    for (const Luminaire& each : world.lights.luminaires) {
        CHECK(each.radiance == Vec3(2));
        CHECK_FALSE(each.varying);
        CHECK(world.lights.luminaire_of[each.primitive] ==
              static_cast<LightIndex>(&each - world.lights.luminaires.data()));
    }
}

TEST_CASE("textures of a blob that is not placed do not go to the next shape", "[world]") {
    Diagnostics diagnostics;
    const World world = survey(scene_of(R"(#version 3.7;
        blob { threshold 0.2 sphere { 0, 1, 1 pigment { rgb x } } }
        torus { 2, 0.5 pigment { rgb 1 } finish { emission 2 } }
    )"),
                               diagnostics);
    REQUIRE(world.lights.luminaires.size() == 1);
    CHECK_FALSE(world.lights.luminaires[0].varying);
}

}  // namespace candelabra
