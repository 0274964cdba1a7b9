// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflected_luminaires.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string that_reflects(int paths, int bounces) {
    return "#version 3.7; global_settings { max_trace_level 12 integrator { path_traced { "
           "bounces " +
           std::to_string(bounces) + " reflected_luminaires " + std::to_string(paths) +
           " } } } #default { finish { ambient 0 diffuse 1 } }\n";
}

const std::string lamps_in_room = R"(
    #for (I, 0, 3) sphere { <I - 1.5, 2.6, 0.5>, 0.15 pigment { rgb 1 }
        finish { diffuse 0 emission <9, 7, 4> } } #end )";
const std::string bare_room = R"(
    box { <-3, 0, -3>, <3, 3, 3> pigment { rgb <0.8, 0.7, 0.6> } }
    box { <-1, 0, 0>, <0, 1, 1> pigment { rgb <0.3, 0.4, 0.8> } } )";

}  // namespace

TEST_CASE("a generation does not depend on the number of threads", "[transport]") {
    const World world = world_of(that_reflects(3000, 4) + lamps_in_room + bare_room);
    const auto set = [&](int threads) {
        const auto all = reflected_luminaires_of(world, 5, threads);
        REQUIRE(all);
        return all->generation(2)->list;
    };
    const auto one = set(1);
    REQUIRE(one.size() > 3000);
    for (const int threads : {2, 7}) {
        const auto other = set(threads);
        REQUIRE(other.size() == one.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            CHECK(other[i].position == one[i].position);
            CHECK(other[i].power == one[i].power);
        }
    }
}

TEST_CASE("reflected luminaires are there where a scene asks for them and has luminaires",
          "[transport]") {
    const auto there = [](const std::string& script) {
        return reflected_luminaires_of(world_of(script), 0, 1) != nullptr;
    };
    CHECK(there(that_reflects(100, 2) + lamps_in_room + bare_room));
    CHECK_FALSE(there(that_reflects(0, 2) + lamps_in_room + bare_room));
    CHECK_FALSE(there(that_reflects(100, 0) + lamps_in_room + bare_room));
    CHECK_FALSE(there(that_reflects(100, 2) + bare_room));
    // One surface that reflects to no other.
    CHECK_FALSE(there(that_reflects(100, 2) + lamps_in_room + "plane { y, 0 pigment { rgb 1 } }"));
    CHECK_FALSE(
        there(that_reflects(100, 2) + lamps_in_room + bare_room + "fog { distance 9 rgb 0.1 }"));
}

}  // namespace candelabra
