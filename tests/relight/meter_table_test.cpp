// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/meter_table.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the table has a row for each point of each meter", "[relight]") {
    LightRecords records;
    records.lamps = LampList({{"A", 1}}, {0}, {1});
    records.meters.nodes = {{0, 1}};
    records.meters.meters = {
        {"a \"b\"", "illuminance", "lx", {{1, 2, 3}, {0, 0, 0.5}}, {0.5F, 0}, {1, 2, 3, 0, 0, 1}},
        {"", "luminance", "cd/m2", {{0, 0, 0}}, {1}, {0, 0, 0}}};
    const std::vector<Rgb> factors = {Rgb(1, 0.5, 0)};
    CHECK(relit_readings(records, factors, "7,") ==
          "7,\"a \"\"b\"\"\",illuminance,lx,1,1,2,3,2.5\n"
          "7,\"a \"\"b\"\"\",illuminance,lx,2,0,0,0.5,0\n"
          "7,meter 2,luminance,cd/m2,1,0,0,0,1\n");
}

}  // namespace candelabra
