// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/light_groups.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("lights of a group light the objects of the group", "[world]") {
    const SharedWorld world = world_of(
        "light_source { y, 1 } sphere { 0, 1 }"
        "light_group { light_source { x, 1 } sphere { 3*x, 1 }"
        "  light_group { light_source { z, 1 } sphere { 6*x, 1 } global_lights } }");
    REQUIRE(world->lights.sources.size() == 3);
    REQUIRE(world->appearance.materials.size() == 3);
    const bool expected[3][3] = {{true, false, false}, {false, true, false}, {false, false, true}};
    for (std::size_t object = 0; object < 3; ++object)
        for (std::size_t light = 0; light < 3; ++light) {
            INFO(object << ' ' << light);
            const std::uint32_t group = world->lights.reach[light].group;
            CHECK(world->reaches(group, world->appearance.materials[object]) ==
                  expected[object][light]);
        }
}

TEST_CASE("a group that comes by a declared name is lit by the group around it, too", "[world]") {
    const SharedWorld world = world_of(
        "#declare Part = light_group { light_source { z, 1 } sphere { 6*x, 1 } }"
        "light_group { light_source { x, 1 } Part }");
    REQUIRE(world->lights.sources.size() == 2);
    REQUIRE(world->appearance.materials.size() == 1);
    for (const LightReach& reach : world->lights.reach)
        CHECK(world->reaches(reach.group, world->appearance.materials[0]));
    CHECK_FALSE(world->reaches(0, world->appearance.materials[0]));
}

TEST_CASE("a light in a union in a group lights what is outside", "[world]") {
    const SharedWorld world = world_of(
        "light_group { union { light_source { x, 1 } sphere { 3*x, 1 } } } sphere { 0, 1 }");
    REQUIRE(world->lights.sources.size() == 1);
    CHECK(world->lights.reach[0].group == 0);
}

}  // namespace candelabra
