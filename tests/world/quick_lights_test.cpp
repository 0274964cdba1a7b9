// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/quick_lights.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

bool is_quick(const BuiltLightSampler& sampler) {
    return std::holds_alternative<BuiltLightBvh>(sampler);
}

}  // namespace

TEST_CASE("lights are chosen without trial for a while, luminaires and sources", "[world]") {
    World world = world_of(R"(#version 3.7;
camera { location -9*z look_at 0 }
plane { y, -2 pigment { rgb 1 } }
#for (I, 1, 300)
    light_source { <I, 5, 0>, 0.01 }
#end
sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
sphere { 3*y, 1 pigment { rgb 1 } finish { emission 1 } })");
    REQUIRE(world.lights.source_sets.size() == 1);
    const SourceSet& many = world.lights.source_sets[0];
    REQUIRE(many.drawn());
    const auto* const octree = std::get_if<BuiltCutOctree>(&world.lights.sampler);
    REQUIRE(octree);
    const auto* const tree = &octree->tree();
    {
        const QuickLights quick(world);
        CHECK(is_quick(world.lights.sampler));
        CHECK(is_quick(many.sampler));
        const Receiver point{Vec3(0, -2, 0), Vec3(0, 1, 0)};
        const BuiltLightBvh& built = std::get<BuiltLightBvh>(world.lights.sampler);
        CHECK(built.expected(point, {}, 0) + built.expected(point, {}, 1) == Approx(1));
    }
    REQUIRE(std::holds_alternative<BuiltCutOctree>(world.lights.sampler));
    CHECK(&std::get<BuiltCutOctree>(world.lights.sampler).tree() == tree);
    CHECK_FALSE(is_quick(many.sampler));
}

TEST_CASE("a world without lights has none to choose", "[world]") {
    World world = world_of("#version 3.7; sphere { 0, 1 pigment { rgb 1 } }");
    const QuickLights quick(world);
    CHECK_FALSE(is_quick(world.lights.sampler));
}

}  // namespace candelabra
