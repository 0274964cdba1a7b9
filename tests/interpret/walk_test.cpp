// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("elements come without directives, in order", "[interpret]") {
    const auto [script, elements] = GENERATE(table<std::string, std::string>({
        {"sphere { 0, 1 } 1 open \"s\"", "block sphere, value, word open, value"},
        {"#declare a = 1; a a + 1 b", "value a, value, word b"},
        {"#for (i, 1, 3) box { } #end", "block box, block box, block box"},
        {"#macro M(n) union { } n #end M(3) M(4)", "block union, value n, block union, value n"},
        {"#macro M(n) #if (n > 0) n + 0 M(n - 1) #end #end M(3)", "value, value, value"},
        {"[0 rgb 1] { 1 } light_octree { }", "entry, braces, block light_octree"},
        {"matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 2, 3> <1, 2>", "word matrix, list, value"},
        {"#declare T = 1; #if (T) #while (T) #declare T = 0; cone { } #end #end", "block cone"},
    }));
    INFO(script);
    const Said result = said(script);
    CHECK(result.messages == "");
    CHECK(result.elements == elements);
}

TEST_CASE("a block is walked when it is asked for", "[interpret]") {
    CHECK(said(prelude + "#declare a = 1; sphere { P(a) #declare a = 2; } P(a)").printed ==
          "1.000000 2.000000 ");
    CHECK(said(prelude + "#macro M(a) sphere { P(a) } #end M(3)").printed == "3.000000 ");
    CHECK(said("#while (1) sphere { #break } #break #end").messages ==
          "error: this #break is in no loop, #switch or macro that it could leave\n");
}

TEST_CASE("a broken value is handed on, but not reported again", "[interpret]") {
    const Said result = said("sphere { nope + 1 } nope * 2");
    CHECK(result.messages ==
          "error: nothing is declared as `nope`\nerror: nothing is declared as `nope`\n");
    CHECK(said("#declare a = nope; #declare b = a + 1; #declare c = sin(b) + <b, a>; c").messages ==
          "error: nothing is declared as `nope`\n");
}

}  // namespace candelabra
