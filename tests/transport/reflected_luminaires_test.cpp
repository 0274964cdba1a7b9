// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflected_luminaires.h"

#include "support/scripts.h"
#include "transport/reflecting_room.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a generation does not depend on the number of threads", "[transport]") {
    const World world = world_of(with_reflected(3000, 4) + lamps_in_room + bare_room);
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
    CHECK(there(with_reflected(100, 2) + lamps_in_room + bare_room));
    CHECK_FALSE(there(with_reflected(0, 2) + lamps_in_room + bare_room));
    CHECK_FALSE(there(with_reflected(100, 0) + lamps_in_room + bare_room));
    CHECK_FALSE(there(with_reflected(100, 2) + bare_room));
    // A single surface, whose light reaches no other.
    CHECK_FALSE(there(with_reflected(100, 2) + lamps_in_room + "plane { y, 0 pigment { rgb 1 } }"));
    CHECK_FALSE(
        there(with_reflected(100, 2) + lamps_in_room + bare_room + "fog { distance 9 rgb 0.1 }"));
}

}  // namespace candelabra
