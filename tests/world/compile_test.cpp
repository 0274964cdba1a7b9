// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/compile.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("every object that emits becomes a luminaire", "[world]") {
    const SharedWorld world = world_of(R"(
        #declare LightProxy = texture { pigment { rgb <1, 0.5, 0> } finish { emission 4 } }
        sphere { 0, 1 texture { LightProxy } }
        triangle { 0, x, y texture { LightProxy } }
        box { 2, 3 texture { LightProxy } }
        disc { 9, y, 1 pigment { checker rgb 1, rgb 0 } finish { emission 2 } }
        sphere { 20, 1 pigment { rgb 0 } finish { emission 4 } }
        sphere { 30, 1 }
    )");
    REQUIRE(world->lights.luminaires.size() == 4);
    CHECK(world->lights.luminaires.own()[0].radiance == Rgb(4, 2, 0));
    CHECK_FALSE(world->lights.luminaires.own()[0].varying);
    CHECK(world->lights.luminaires.own()[3].varying);
    CHECK(world->lights.luminaires.own()[3].radiance == Rgb(2));
    CHECK(world->provenance.object_count == 6);
}

TEST_CASE("the command line's light sampler goes before the scene's", "[world]") {
    Diagnostics diagnostics;
    const Scene scene =
        scene_of("global_settings { light_sampler { every_light } } sphere { 0, 1 }");
    CHECK(Shot(compile(scene, {}, diagnostics)).sampler.index() ==
          LightSampler(EveryLight{}).index());
    CompileOptions options;
    options.light_sampler = LinearAlpha{};
    CHECK(Shot(compile(scene, options, diagnostics)).sampler.index() ==
          LightSampler(LinearAlpha{}).index());
}

TEST_CASE("an empty scene has a world", "[world]") {
    const SharedWorld world = world_of("");
    Hit hit;
    CHECK_FALSE(world->first_hit({Vec3(0), Vec3(0, 0, 1)}, 0, RayKind::camera, hit));
}

TEST_CASE("a survey finds the materials and luminaires that a world has, and no other primitives") {
    const std::string script = R"(
        sphere { 0, 1 pigment { rgb 1 } }
        sphere { 3, 1 pigment { rgb 1 } finish { emission 1 } }
        union { box { 5, 6 } difference { box { 5, 6 } sphere { 5, 1 } } pigment { rgb 0.5 } }
        difference { box { 7, 8 } sphere { 8, 1 finish { emission 2 } pigment { rgb 1 } } }
    )";
    Diagnostics diagnostics;
    const Scene scene = scene_of(script);
    const SharedWorld world = compile(scene, {}, diagnostics), seen = survey(scene, diagnostics);
    CHECK(seen->provenance.object_count == world->provenance.object_count);
    CHECK(seen->appearance.materials.size() == world->appearance.materials.size());
    CHECK(seen->lights.luminaires.size() == world->lights.luminaires.size());
    CHECK(seen->geometry.spheres.size() == 1);
    CHECK(seen->geometry.shapes.empty());
    CHECK(seen->geometry.composites.size() == 1);
}

}  // namespace candelabra
