// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/materials.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

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
    CHECK(world.appearance.materials[3].texture == red);
    CHECK(world.appearance.materials[3].solid == 3);
}

TEST_CASE("faces whose corners differ have a material for all that look so", "[world]") {
    World world;
    Materials materials(world);
    const auto grey = make_handle<Texture>();
    auto lamp = make_handle<Texture>();
    lamp.edit().pigment.colour.rgb = lamp.edit().finish.emission = Rgb(1);
    Inherited look;
    look.texture = &grey;
    std::vector<std::uint32_t> of_mesh = {materials.index(look)};
    look.texture = &lamp;
    of_mesh.push_back(materials.index(look));
    CHECK(materials.of_face(of_mesh, {0, 0, 0}) == of_mesh[1]);
    const std::uint32_t mixed = materials.of_face(of_mesh, {-1, 0, -1});
    CHECK(mixed == materials.of_face(of_mesh, {-1, 0, -1}));
    CHECK(mixed != materials.of_face(of_mesh, {0, -1, -1}));
    CHECK(world.appearance.materials[mixed].texture2 == lamp);
    CHECK(materials.glows(mixed));
    CHECK_FALSE(materials.glows(of_mesh[0]));
}

TEST_CASE("faces between two looks have what either of them has", "[world]") {
    World world;
    Materials materials(world);
    auto grey = make_handle<Texture>(), shiny = make_handle<Texture>();
    grey.edit().finish.ambient = shiny.edit().finish.ambient = Rgb(0);
    shiny.edit().finish.phong = 1;
    Inherited look;
    look.texture = &grey;
    std::vector<std::uint32_t> of_mesh = {materials.index(look)};
    look.texture = &shiny;
    of_mesh.push_back(materials.index(look));
    CHECK_FALSE(world.appearance.materials[of_mesh[0]].other_light);
    CHECK(world.appearance.materials[materials.of_face(of_mesh, {-1, 0, -1})].other_light);
}

TEST_CASE("materials know whether a pattern of any side depends on the ray", "[world]") {
    const auto by_view = [](const std::string& looks) {
        const Material material =
            world_of("#version 3.7; sphere { 0, 1 " + looks + " }")->appearance.materials.front();
        CHECK(material.other_light == material.by_view);
        return material.by_view;
    };
    CHECK_FALSE(by_view("pigment { slope { y } } finish { ambient 0 }"));
    CHECK(by_view("pigment { aoi } finish { ambient 0 }"));
    CHECK(by_view("pigment { rgb 1 } normal { aoi 0.3 } finish { ambient 0 }"));
    CHECK(
        by_view("texture { aoi texture_map { [0 pigment { rgb 1 } finish { ambient 0 }] "
                "[1 pigment { rgb 0.5 } finish { ambient 0 }] } }"));
    CHECK(
        by_view("texture { pigment { rgb 1 } finish { ambient 0 } } "
                "interior_texture { pigment { aoi } finish { ambient 0 } }"));
}

TEST_CASE("what differs in its lights or inside is another material", "[world]") {
    const auto materials = [](const std::string& looks) {
        return world_of("#version 3.7; " + looks)->appearance.materials.size();
    };
    CHECK(materials("sphere { 0, 1 } sphere { 3*x, 1 }") == 1);
    CHECK(materials("sphere { 0, 1 } light_group { sphere { 3*x, 1 } }") == 2);
    CHECK(materials("sphere { 0, 1 } sphere { 3*x, 1 interior_texture { pigment { rgb 1 } } }") ==
          2);
}

TEST_CASE("the index of refraction of a finish replaces that of the interior", "[world]") {
    const SharedWorld world = world_of(
        "sphere { 0, 1 finish { ior 1.3 } interior { ior 1.5 fade_distance 2 fade_power 1 } }");
    CHECK(world->appearance.materials.front().interior->ior == 1.3);
    CHECK(world->appearance.materials.front().interior->fade_distance == 2);
}

TEST_CASE("ambient of 1 and more makes luminaires where that is wanted", "[world]") {
    const std::string spheres =
        "sphere { 0, 1 pigment { rgb <1, 0.5, 0> } finish { ambient 2 } }"
        "sphere { 3*x, 1 finish { ambient 0.9 } }";
    CHECK(world_of(spheres)->lights.luminaires.empty());
    const SharedWorld world =
        world_of("global_settings { luminaires ambient ambient_light 3 } " + spheres);
    REQUIRE(world->lights.luminaires.size() == 1);
    CHECK(world->lights.luminaires.own().front().radiance == Rgb(6, 3, 0));
    const SharedWorld map = world_of(
        "#version 3.7; global_settings { luminaires ambient } sphere { 0, 1 texture { gradient y "
        "texture_map { [0 pigment { rgb 1 } finish { ambient 1 }] [1 pigment { rgb 0 }] } } }");
    CHECK(map->lights.luminaires.size() == 1);
}

TEST_CASE("what glows is a luminaire unless something says that it lights nothing", "[world]") {
    const std::string dim = "sphere { 0, 1 pigment { rgb <0.5, 0, 0> } finish { emission 0.5 } }",
                      bright = "sphere { 3*x, 1 pigment { rgb 1 } finish { emission 0.5 } }",
                      both = dim + bright;
    struct Case {
        std::string script;
        std::size_t luminaires;
    };
    const auto [script, luminaires] = GENERATE_COPY(values<Case>({
        {both, 2},
        {"global_settings { luminaires none } " + both, 0},
        {"global_settings { luminaires above 0.25 } " + both, 1},
        {"global_settings { luminaires above 0.24 } " + both, 2},
        {"global_settings { luminaires none } global_settings { luminaires emission } " + both, 2},
        {"object { " + dim + " no_luminaire } " + bright, 1},
        {"union { " + both + " no_luminaire }", 0},
        {"union { " + bright + " object { " + dim + " no_luminaire } }", 1},
        {"difference { " + bright + " sphere { 4*x, 1 } no_luminaire }", 0},
        {"sphere { 0, 1 pigment { rgb 1 } finish { emission 0.5 no_luminaire } }", 0},
        {"sphere { 0, 1 texture { gradient y texture_map { [0 pigment { rgb 1 } finish { emission "
         "1 "
         "no_luminaire }] [1 pigment { rgb 1 } finish { emission 0.1 }] } } }",
         1},
    }));
    INFO(script);
    CHECK(world_of("#version 3.7; " + script)->lights.luminaires.size() == luminaires);
}

TEST_CASE("what lights nothing is seen to glow as before", "[world]") {
    const SharedWorld world = world_of(
        "camera { location -3*z } sphere { 0, 1 pigment { rgb 1 } finish { emission 0.5 "
        "no_luminaire } }");
    REQUIRE(world->lights.luminaires.empty());
    CHECK(world->emission(0, Vec3(0, 0, -1), Side::outer) == Rgb(0.5));
}

}  // namespace candelabra
