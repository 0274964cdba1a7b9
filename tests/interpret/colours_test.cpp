// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("colours have POV-Ray's values", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare C = rgb 1; V(5,C)", "<1.0000,1.0000,1.0000,0.0000,0.0000>"},
        {"#declare C = rgbt .5; V(5,C)", "<0.5000,0.5000,0.5000,0.0000,0.5000>"},
        {"#declare C = rgbf <1,2,3,4>; V(5,C)", "<1.0000,2.0000,3.0000,4.0000,0.0000>"},
        {"#declare C = rgbft <1,2,3,4,5>; V(5,C)", "<1.0000,2.0000,3.0000,4.0000,5.0000>"},
        {"#declare C = rgb <1,2,3>*.5; V(3,C)", "<0.5000,1.0000,1.5000>"},
        {"#declare C = color rgb <1,2,3>; V(3,C)", "<1.0000,2.0000,3.0000>"},
        {"#declare C = color red 1 blue 2 red 3; V(5,C)", "<3.0000,0.0000,2.0000,0.0000,0.0000>"},
        {"#declare C = rgb 1 filter .5 transmit .25; V(5,C)",
         "<1.0000,1.0000,1.0000,0.5000,0.2500>"},
        {"#declare A = rgb 1; #declare C = A green 0; V(5,C)",
         "<1.0000,0.0000,1.0000,0.0000,0.0000>"},
        {"#declare C = srgb <0, 0.5, 1>; V(3,C)", "<0.0000,0.2140,1.0000>"},
        {"#declare C = rgb <1,.5,0>; P(C.gray) P(C.green) P(C.transmit)",
         "0.591500 0.500000 0.000000"},
        {"#declare C = rgb \"s\";", "error: `rgb` takes numbers, but this is the string \"s\"\n"},
        {"#declare C = rgb <1, 2>;", "warning: `rgb` takes 3 numbers, but here are 2\n"},
        {"#declare C = color \"s\";", "error: a colour is wanted, but this is the string \"s\"\n"},
        {"#declare C = color red x;",
         "error: the amount of `red` must be a number, but it is a vector of 3\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("channels join the colour before them", "[interpret]") {
    CHECK(said("#declare R = rgb 1; R filter .5 transmit 1").elements == "value");
    CHECK(said("red 1 green 2").elements == "value");
    CHECK(said("<0, 0, 0> red 1").elements == "value, value");
    CHECK(said("filter all 1").elements == "word filter, word all, value");
}

}  // namespace candelabra
