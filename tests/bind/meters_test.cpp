// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/meters.h"

#include "meter/road_table.h"
#include "scene/dump.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Script with_road(const std::string& table, const std::string& quantity = "luminance") {
    return run("#version 3.7; meter { \"road\" " + quantity +
                   " eye <-60, 1.5, 0> direction x points { 1, 0 } road_table \"r.csv\" }",
               {{"r.csv", table}});
}

}  // namespace

TEST_CASE("a meter reads the table of a road in the forms that programs write", "[bind]") {
    const RoadTable expected{{0, 0.5}, {0, 2, 5}, {700, 710, 720, 600, 0, 620}};
    for (const char* const table : {"tan,0,2,5\n0,700,710,720\n0.5,600,,620\n",
                                    "# R3\nbeta;0;2;5\n0;700;710;720\n0,5;600;;620\n",
                                    "\"\"\t0\t2\t5\r\n0\t700\t710\t720\r\n.5\t600\t\t620"}) {
        CAPTURE(table);
        const Script done = with_road(table);
        CHECK(done.text.empty());
        REQUIRE(done.scene.meters.size() == 1);
        REQUIRE(done.scene.meters[0].surface);
        CHECK(*done.scene.meters[0].surface == expected);
        CHECK(dump(done.scene).find("road_table \"r.csv\"") != std::string::npos);
    }
}

TEST_CASE("what is wrong with the file of a road is said at the meter", "[bind]") {
    struct Wrong {
        std::string table, expected;
    };
    for (const Wrong& row : std::vector<Wrong>{{"", "`r.csv`"},
                                               {"tan\n0\n", "angles beta"},
                                               {"tan,0,200\n0,1,1\n", "angles beta"},
                                               {"tan,0,x\n0,1,1\n", "angles beta"},
                                               {"tan,0,2\n1,1,1\n0,1,1\n", "tangents"},
                                               {"tan,0,2\n,1,1\n", "tangents"},
                                               {"tan,0,2\n0,1,-1\n", "entries"},
                                               {"tan,0,2\n0,1,one\n", "not a number"},
                                               {"tan,0,2\n0,1\n", "`r.csv`"}}) {
        CAPTURE(row.table);
        const Script done = with_road(row.table);
        CHECK(done.text.find(row.expected) != std::string::npos);
        CHECK(done.scene.meters.empty());
    }
    CHECK(with_road("tan,0\n0,1\n", "illuminance").text.find("is for `luminance`") !=
          std::string::npos);
    CHECK_FALSE(run("#version 3.7; meter { luminance direction x points { 1, 0 } road_table "
                    "\"none.csv\" }")
                    .text.empty());
}

}  // namespace candelabra
