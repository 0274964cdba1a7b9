// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_ledger.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a ledger has the light of each statement until it is taken", "[transport]") {
    const SharedWorld world = world_of(R"(
        sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
        sphere { 3, 1 pigment { rgb 1 } }
        sphere { 6, 1 pigment { rgb 1 } finish { emission 2 } })");
    LightLedger ledger;
    record_seen(ledger, *world, 0, Rgb(1));  // lights are not counted
    CHECK(ledger.lights.empty());
    ledger = empty_ledger(*world, true);
    record_seen(ledger, *world, 0, Rgb(1, 2, 3));
    record_seen(ledger, *world, 1, Rgb(9));  // no luminaire
    record_seen(ledger, *world, 2, Rgb(4));
    for (const bool again : {false, true}) {
        std::vector<Rgb> taken;
        take_lights(ledger, [&](std::size_t, const Rgb& light) { taken.push_back(light); });
        CHECK(taken ==
              (again ? std::vector<Rgb>(2, Rgb(0)) : std::vector<Rgb>{Rgb(1, 2, 3), Rgb(4)}));
    }
}

TEST_CASE("a flame's light is counted for the statement of its luminaires", "[transport]") {
    World world(*world_of(R"(
        sphere { 3, 1 pigment { rgb 1 } finish { emission 1 } }
        sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { emission 1 } luminaire } })"));
    REQUIRE(world.provenance.light_statements.size() == 2);
    // A shutter renumbers the statements of its moments.
    for (std::uint32_t& statement : world.provenance.statement_of_luminaire)
        statement = 1 - statement;
    LightLedger ledger = empty_ledger(world, true);
    const EnteredSolids flame = world.containing(Vec3(0));
    REQUIRE(flame.size() == 1);
    record_volume(ledger, world, {flame.data(), flame.size()}, Rgb(2));
    CHECK(ledger.lights[0].seen == Rgb(2));
    CHECK(ledger.lights[1].seen == Rgb(0));
}

TEST_CASE("ledgers of several jobs add up", "[transport]") {
    LightLedger all, one;
    one.camera = 1;
    one.shadow = 2;
    one.scattered = 3;
    one.lights.resize(2);
    one.lights[1].rays = 5;
    all += one;
    all += one;
    CHECK(all.camera == 2);
    CHECK(all.shadow == 4);
    CHECK(all.scattered == 6);
    CHECK(all.lights[1].rays == 10);
}

}  // namespace candelabra
