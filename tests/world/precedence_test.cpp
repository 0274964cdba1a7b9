// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/precedence.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

bool is_red(const World& world, const Vec3& from, const Vec3& to) {
    Hit hit;
    REQUIRE(world.first_hit({from, unit(to - from)}, 1e-6, RayKind::camera, hit));
    return world.material(hit.primitive).texture->pigment.colour.rgb == Rgb(1, 0, 0);
}

}  // namespace

TEST_CASE("of surfaces in one place that whose box the ray enters first is hit", "[world]") {
    const std::string table = "box { <-9, -1, -9>, <9, 0, 9> }",
                      dome = "intersection { sphere { 0, 1 } plane { -y, 0 } pigment { rgb x } }";
    for (const std::string& scene : {table + dome, dome + table}) {
        const SharedWorld world = world_of(scene);
        CHECK(is_red(*world, Vec3(0.1, 0.5, 0), Vec3(0.2, 0, 0.1)));
        CHECK_FALSE(is_red(*world, Vec3(0.1, -0.5, 0), Vec3(0.2, 0, 0.1)));
    }
}

TEST_CASE("what has no end comes before all that is in the same place", "[world]") {
    const std::string things[] = {"box { <-1, 0, -1>, <1, 1, 1> }",
                                  "mesh { triangle { <-2, 0, -2>, <2, 0, -2>, <0, 0, 2> } }",
                                  "intersection { sphere { 0, 1 } plane { -y, 0 } }",
                                  "disc { 0, y, 1 }"};
    const std::string floors[] = {"plane { y, 0 pigment { rgb x } }",
                                  "plane { -y, 0 inverse pigment { rgb x } }",
                                  "intersection { plane { y, 0 } pigment { rgb x } }"};
    for (const std::string& thing : things)
        for (const std::string& floor : floors)
            for (const std::string& scene : {floor + thing, thing + floor})
                CHECK(is_red(*world_of(scene), Vec3(0.1, 0.5, 0), Vec3(0.2, 0, 0.1)));
}

}  // namespace candelabra
