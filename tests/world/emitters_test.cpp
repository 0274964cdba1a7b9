// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/emitters.h"

#include "support/draw.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("primitives of each kind become luminaires", "[world]") {
    const SharedWorld world = world_of(R"(#version 3.7;
        #default { pigment { rgb 1 } finish { emission 2 } }
        torus { 2, 0.5 }
        difference { box { 0, 1 } sphere { 0, 0.5 } }
        triangle { 0, x, y }
        sphere { 5, 1 }
        superellipsoid { <0.5, 0.5> translate 9*x }
    )");
    CHECK(world->lights.luminaires.size() == 6);
    const auto made = [&](auto kind) {
        return std::ranges::count_if(world->lights.luminaires.own(), [](const Luminaire& each) {
            return std::holds_alternative<decltype(kind)>(each.emitter);
        });
    };
    CHECK(made(SphereEmitter()) == 1);
    CHECK(made(TriangleEmitter()) == 1);
    for (const Luminaire& each : world->lights.luminaires.own()) {
        CHECK(each.radiance == Rgb(2));
        CHECK_FALSE(each.varying);
        CHECK(world->lights.luminaire_of[each.primitive] ==
              static_cast<LightIndex>(&each - world->lights.luminaires.own().data()));
    }
}

TEST_CASE("textures of a blob that is not placed do not go to the next shape", "[world]") {
    Diagnostics diagnostics;
    const SharedWorld world = survey(scene_of(R"(#version 3.7;
        blob { threshold 0.2 sphere { 0, 1, 1 pigment { rgb x } } }
        torus { 2, 0.5 pigment { rgb 1 } finish { emission 2 } }
    )"),
                                     diagnostics);
    REQUIRE(world->lights.luminaires.size() == 1);
    CHECK_FALSE(world->lights.luminaires.own()[0].varying);
}

TEST_CASE("copies of a shape share the triangles at which rays are aimed", "[world]") {
    const SharedWorld world = world_of(R"(#version 3.7;
        #declare Letter = text { ttf "timrom.ttf" "g" 0.2, 0 pigment { rgb 1 }
                                 finish { emission 2 diffuse 0 } }
        #for (I, 0, 99) object { Letter rotate 7*I*y scale <1, 1 + I/50, 1> translate 3*I*x } #end
        plane { y, 0 pigment { rgb 1 } })");
    REQUIRE(world->lights.luminaires.size() == 100);
    for (const Luminaire& each : world->lights.luminaires.own()) {
        const auto& letter = std::get<CompositeEmitter>(each.emitter);
        CHECK(letter.proxy);
        CHECK(letter.closed);
        CHECK(letter.seen_area > 0);
        // The triangles are where the letter is: rays that are aimed at it meet it.
        const LightBounds around = bounds(each);
        Draw draw(1);
        int met = 0;
        for (int i = 0; i < 100; ++i)
            met += sample(each, around.centre + 5 * around.radius * draw.direction(),
                          {draw.number(), draw.number()})
                       .has_value();
        CHECK(met > 70);
    }
}

TEST_CASE("nothing is a luminaire where no surface and no medium shows its light", "[world]") {
    const std::string lamps = R"(#version 3.7; #default { finish { ambient 0 diffuse 0 } }
        #for (I, 0, 9) sphere { I*x, 0.3 pigment { rgb 1 } finish { emission 1 } } #end
        box { -0.2, 0.2 translate 2*y pigment { rgb 1 } finish { reflection 0.5 emission 1 } } )";
    const SharedWorld dark = world_of(lamps);
    CHECK(dark->lights.luminaires.empty());
    CHECK_FALSE(dark->facts.differs_by_light);
    CHECK(glows_without_light(*dark) == 11);
    for (const char* const receiver :
         {"plane { y, -1 pigment { rgb 1 } finish { diffuse 0.1 } }",
          "plane { y, -1 pigment { rgb 1 } finish { diffuse 0, 0.1 } }",
          "plane { y, -1 pigment { rgb 1 } finish { phong 1 } }",
          "plane { y, -1 pigment { rgb 1 } finish { specular 1 } }",
          "plane { y, -1 pigment { rgb 1 } finish { microfacet { roughness 0.3 } } }",
          "plane { y, -1 texture { pigment { rgb 1 } } "
          "interior_texture { pigment { rgb 1 } finish { diffuse 1 } } }",
          "plane { y, -1 texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } "
          "finish { diffuse 1 } } }",
          "media { scattering { 1, 0.1 } }",
          "sphere { 0, 9 hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.1 } } } "
          "}"}) {
        CAPTURE(receiver);
        CHECK(world_of(lamps + receiver)->lights.luminaires.size() == 11);
    }
    // A mirror shows the lamps themselves.
    CHECK(world_of(lamps + "plane { y, -1 pigment { rgb 1 } finish { reflection 1 } }")
              ->lights.luminaires.empty());
}

}  // namespace candelabra
