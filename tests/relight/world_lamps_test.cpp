// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/world_lamps.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("lamps beside each other are beside each other in the list", "[relight]") {
    const SharedWorld world = world_of(R"(
        light_source { <0, 9, 0>, rgb 2 }
        #for (I, 0, 15)
            sphere { <mod(7*I, 16), 0, 0>, 0.1 pigment { rgb 1 } finish { emission 1 } }
        #end
        light_source { <5, 9, 0>, rgb 1 })");
    REQUIRE(world->provenance.light_statements.size() == 3);
    const WorldLamps lamps = world_lamps(*world, {"A", "B", "C"});
    CHECK(lamps.list.size() == 18);
    CHECK(are_numbers_of(lamps.list.groups(), lamps.list.numbers()));
    const std::size_t row = world->provenance.statement_of(Lamp::luminaire(0));
    const LampRange range = lamps.list.range_of(row);
    REQUIRE(range.size() == 16);
    for (std::uint32_t i = 0; i < 16; ++i) {
        // The lamp with number i is at mod(7 i, 16), and so is its place.
        CHECK(lamps.list.place_of(row, i) - range.first == 7 * i % 16);
        CHECK(lamps.place_of(Lamp::luminaire(i)) == lamps.list.place_of(row, i));
    }
    const std::uint32_t bright = lamps.place_of(Lamp::source(0)),
                        dim = lamps.place_of(Lamp::source(1));
    CHECK(lamps.list.powers()[bright] == Approx(2 * lamps.list.powers()[dim]));
}

TEST_CASE("every lamp has a power above 0", "[relight]") {
    const SharedWorld world = world_of(R"(
        light_source { <0, 9, 0>, rgb 0 }
        light_source { <0, 9, 0>, rgb 1e30 })");
    const WorldLamps lamps = world_lamps(*world, {"A", "B"});
    for (const float power : lamps.list.powers()) {
        CHECK(power > 0);
        CHECK(power <= 1e7F);
    }
}

}  // namespace candelabra
