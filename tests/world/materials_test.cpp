// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/materials.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

TEST_CASE("what looks the same is one material, unless it is its own", "[world]") {
    World world;
    Materials materials(world);
    const auto grey = make_handle<Texture>(), red = make_handle<Texture>();
    Inherited look;
    look.texture = &grey;
    CHECK(materials.index(look) == 0);
    CHECK(materials.index(look) == 0);
    look.texture = &red;
    CHECK(materials.index(look) == 1);
    look.no_shadow = true;
    CHECK(materials.index(look) == 2);
    CHECK(materials.own(1) == 3);
    CHECK(world.materials[3].texture == red);
    CHECK(world.materials[3].solid == 3);
}

TEST_CASE("faces whose corners differ have a material for all that look so", "[world]") {
    World world;
    Materials materials(world);
    const auto grey = make_handle<Texture>();
    auto lamp = make_handle<Texture>();
    lamp.edit().pigment.colour.rgb = lamp.edit().finish.emission = Vec3(1);
    Inherited look;
    look.texture = &grey;
    std::vector<std::uint32_t> of_mesh = {materials.index(look)};
    look.texture = &lamp;
    of_mesh.push_back(materials.index(look));
    CHECK(materials.of_face(of_mesh, {0, 0, 0}) == of_mesh[1]);
    const std::uint32_t mixed = materials.of_face(of_mesh, {-1, 0, -1});
    CHECK(mixed == materials.of_face(of_mesh, {-1, 0, -1}));
    CHECK(mixed != materials.of_face(of_mesh, {0, -1, -1}));
    CHECK(world.materials[mixed].texture2 == lamp);
    CHECK(materials.glows(mixed));
    CHECK_FALSE(materials.glows(of_mesh[0]));
}
