// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/road_tables.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a table of a road has angles in its first row and tangents in its first column",
          "[bind]") {
    RoadTable table;
    CHECK(read_road_table("tan,0,90\n0,120,130\n2,40,\n", table).empty());
    CHECK(table.angles == std::vector<double>{0, 90});
    CHECK(table.tangents == std::vector<double>{0, 2});
    CHECK(table.entries == std::vector<double>{120, 130, 40, 0});
}

TEST_CASE("a table of a road has a tangent in each row", "[bind]") {
    for (const char* text :
         {"tan,0\n0,1\n,1\n2,1\n", "tan,0\n0,1\nnan,1\n2,1\n", "tan,0,,9\n0,1,1,1\n",
          "tan,0,nan,9\n0,1,1,1\n", "", "\n", "tan\n1\n"}) {
        RoadTable table;
        CAPTURE(text);
        CHECK_FALSE(read_road_table(text, table).empty());
    }
}

}  // namespace candelabra
