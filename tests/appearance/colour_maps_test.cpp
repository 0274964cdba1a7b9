// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/colour_maps.h"

#include "support/script.h"
#include "surface/pigment_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

ColourMap map_of(const std::string& entries) {
    const Script done =
        run("#version 3.7; #declare Red = rgb x; #declare M = color_map { [0 Red] "
            "[1 rgb 1] } sphere { 0, 1 pigment { bozo color_map { " +
            entries + " } } }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    return std::get<ColourMap>(done.texture().pigment.pattern->map);
}

}  // namespace

TEST_CASE("an entry has a value and a colour, or two of each", "[appearance]") {
    CHECK(map_of("[0 Red] [0.5, rgb 1]") == ColourMap{{0, {Rgb(1, 0, 0)}}, {0.5, {Rgb(1)}}});
    CHECK(map_of("[0.25, 0.75 color Red color rgb 1]") ==
          ColourMap{{0.25, {Rgb(1, 0, 0)}}, {0.75, {Rgb(1)}}});
}

TEST_CASE("values are kept in single precision", "[appearance]") {
    CHECK(map_of("[0.1 Red]").front().value == static_cast<double>(0.1f));
}

TEST_CASE("a declared map can be used", "[appearance]") { CHECK(map_of("M").size() == 2); }

}  // namespace candelabra
