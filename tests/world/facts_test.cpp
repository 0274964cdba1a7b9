// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/facts.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <string>

namespace candelabra {

TEST_CASE("questions about a scene are answered once it is compiled", "[world]") {
    const std::string ground = "#version 3.7; plane { y, 0 } ";
    const WorldFacts plain = world_of(ground + "light_source { 5*y, 1 }")->facts;
    CHECK_FALSE(plain.has_air);
    CHECK_FALSE(plain.has_media);
    CHECK_FALSE(plain.notes_solids);
    CHECK(plain.is_lit_by_lamps_only);
    CHECK_FALSE(plain.left_to_chance);
    SECTION("of air and media") {
        const WorldFacts foggy = world_of(ground + "fog { distance 9 rgb 1 }")->facts;
        CHECK(foggy.has_air);
        CHECK(foggy.notes_solids);
        CHECK_FALSE(foggy.has_media);
        CHECK(world_of(ground + "media { emission 1 }")->facts.has_media);
        const std::string smoke = "media { scattering { 1, 0.1 } intervals 1 method 1 }";
        const WorldFacts filled =
            world_of(ground + "sphere { 0, 1 pigment { rgbt 1 } hollow interior { " + smoke +
                     " } }")
                ->facts;
        CHECK(filled.has_media);
        CHECK_FALSE(filled.has_air);
        CHECK(filled.left_to_chance);
        CHECK_FALSE(filled.differs_by_light);
    }
    SECTION("of light") {
        const WorldFacts lamp =
            world_of(ground + "sphere { y, 0.1 pigment { rgb 1 } finish { emission 1 } }")->facts;
        CHECK(lamp.is_lit_by_lamps_only);
        const auto by_lamps = [&](const std::string& sky) {
            return world_of(ground + sky)->facts.is_lit_by_lamps_only;
        };
        CHECK(by_lamps("sky_sphere { pigment { rgb 1 } luminaire }"));
        CHECK_FALSE(by_lamps("sky_sphere { pigment { rgb 1 } }"));
        CHECK_FALSE(by_lamps("background { rgb 1 }"));
        CHECK_FALSE(by_lamps("fog { distance 9 rgb 1 }"));
        CHECK(lamp.light_is_drawn);
        CHECK(lamp.differs_by_light);
        CHECK(lamp.left_to_chance);
        CHECK_FALSE(lamp.has_indirect_light);
        const WorldFacts gathers = world_of("global_settings { radiosity { } } " + ground)->facts;
        CHECK(gathers.gathers_light);
        CHECK(gathers.has_indirect_light);
        CHECK_FALSE(gathers.keeps_energy);
        const WorldFacts traced =
            world_of("global_settings { integrator { path_traced { } } } " + ground)->facts;
        CHECK_FALSE(traced.gathers_light);
        CHECK(traced.has_indirect_light);
        CHECK(traced.keeps_energy);
        CHECK(traced.left_to_chance);
    }
    SECTION("of rays") {
        CHECK(world_of("camera { orthographic } " + ground)->facts.indexes_solids);
        CHECK_FALSE(plain.indexes_solids);
    }
}

}  // namespace candelabra
