// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/knobs.h"

#include <catch2/catch.hpp>

#include <initializer_list>
#include <utility>

namespace candelabra {

TEST_CASE("documented names can be turned") {
    const auto found = knobs(
        "#ifndef (Height) #declare Height = 2; #end  // 0 to 5 by 0.5: how tall it is\n"
        "#ifndef (Turn)\n    #declare Turn = -30;\n#end // -180 to 180\n"
        "sphere { 0, Height }");
    using enum Knob::Kind;
    REQUIRE(found.size() == 2);
    CHECK(found[0] == Knob{"Height", 2.0, slider, 0, 5, 0.5, {}, "how tall it is"});
    CHECK(found[1] == Knob{"Turn", -30.0, slider, -180, 180, 3.6});
}

TEST_CASE("a comment says what kind of value a name has, and headings make sections") {
    const auto found = knobs(R"(
        #ifndef (A) #declare A = 1; #end // on or off: whether it snows
        // [The tree]
        #ifndef (B) #declare B = 5; #end // one of 3, 5, 8
        #ifndef (C) #declare C = "fir"; #end // one of "oak", "fir": its kind
        // [Colours]
        #ifndef (D) #declare D = "Hello"; #end // text
        #ifndef (E) #declare E = rgb <1, 0.5, 0>; #end // colour: of the wax
        #ifndef (F) #declare F = <0, 0.5, 1>; #end // color
        #ifndef (G) #declare G = <-1, 0, 1>; #end // -5 to 5 by 1: where
    )");
    using enum Knob::Kind;
    REQUIRE(found.size() == 7);
    CHECK(found[0] == Knob{"A", 1.0, toggle, 0, 0, 0, {}, "whether it snows"});
    CHECK(found[1] == Knob{"B", 5.0, list, 0, 0, 0, {3.0, 5.0, 8.0}, "", "The tree"});
    CHECK(found[2] == Knob{"C",
                           std::string("fir"),
                           list,
                           0,
                           0,
                           0,
                           {std::string("oak"), std::string("fir")},
                           "its kind",
                           "The tree"});
    CHECK(found[3] == Knob{"D", std::string("Hello"), text, 0, 0, 0, {}, "", "Colours"});
    CHECK(found[4].kind == colour);
    CHECK(std::get<Numbers>(found[4].value) == Numbers::colour({Rgb(1, 0.5, 0), 0, 0}));
    CHECK(found[5].kind == colour);
    CHECK(std::get<Numbers>(found[5].value) == Numbers::vector(Vec3(0, 0.5, 1)));
    CHECK(found[6] ==
          Knob{"G", Numbers::vector(Vec3(-1, 0, 1)), vector, -5, 5, 1, {}, "where", "Colours"});
}

TEST_CASE("what is not in the form is left alone") {
    for (const char* scene : {"#ifndef (A) #declare A = 2; #end",
                              "#ifndef (A) #declare A = 2; #end // how tall",
                              "#ifndef (A) #declare A = 2; #end\n// 0 to 5",
                              "#ifdef (A) #declare A = 2; #end // 0 to 5",
                              "#ifndef (A) #declare B = 2; #end // 0 to 5",
                              "#ifndef (A) #declare A = 2*3; #end // 0 to 5",
                              "#ifndef (A) #declare A = 2; #end // 5 to 0",
                              "#ifndef (A) #declare A = 2; // 0 to 5",
                              "#ifndef (A) #declare A = 2; #end // 0 to 5 by 0",
                              "#ifndef (A) #declare A = 2; #end // on or off",
                              "#ifndef (A) #declare A = 2; #end // one of 3, 4",
                              "#ifndef (A) #declare A = 2; #end // one of 2, x",
                              "#ifndef (A) #declare A = 2; #end // text",
                              "#ifndef (A) #declare A = \"a\"; #end // one of \"b",
                              "#ifndef (A) #declare A = \"a\"; #end // 0 to 5",
                              "#ifndef (A) #declare A = <1, 2>; #end // 0 to 5",
                              "#ifndef (A) #declare A = srgb <1, 0, 0>; #end // colour",
                              "#ifndef (A) #declare A = -<1, 0, 0>; #end // colour",
                              "#ifndef (A) #declare A = rgb 1; #end // colour",
                              "#ifndef (A) #declare A =",
                              "#ifndef (A) #declare A = rgb",
                              "#ifndef"}) {
        CAPTURE(scene);
        CHECK(knobs(scene).empty());
    }
}

TEST_CASE("texts of the page are values of their knob, or none") {
    using enum Knob::Kind;
    const auto value = [](const Knob& knob, std::string_view stated) {
        return knob_value(knob, stated);
    };
    const Knob number{"A", 1.0, slider, 0, 2, 0.1}, on{"B", 1.0, toggle},
        one{"C", 5.0, list, 0, 0, 0, {3.0, 5.0}},
        kind{"D", std::string("a"), list, 0, 0, 0, {std::string("a"), std::string("b")}},
        words{"E", std::string("a"), text}, tint{"F", Numbers::colour({Rgb(1), 0, 0}), colour},
        place{"G", Numbers::vector(Vec3(0)), vector, -1, 1, 0.1};
    CHECK(value(number, "1.5") == KnobValue(1.5));
    CHECK(value(number, "7") == KnobValue(2.0));
    CHECK(value(on, "3") == KnobValue(1.0));
    CHECK(value(one, "3") == KnobValue(3.0));
    CHECK(value(kind, "b") == KnobValue(std::string("b")));
    CHECK(value(words, "<script> & more") == KnobValue(std::string("<script> & more")));
    CHECK(value(tint, "0.5,-1,8") == KnobValue(Numbers::colour({Rgb(0.5, 0, 8), 0, 0})));
    CHECK(value(place, "0.5,-3,3") == KnobValue(Numbers::vector(Vec3(0.5, -1, 1))));
    for (const auto& [knob, wrong] :
         std::initializer_list<std::pair<Knob, std::string>>{{number, "x"},
                                                             {number, ""},
                                                             {number, "inf"},
                                                             {on, "on"},
                                                             {one, "4"},
                                                             {kind, "c"},
                                                             {words, "a \" b"},
                                                             {words, std::string(20'000, 'a')},
                                                             {tint, "1,2"},
                                                             {tint, "1,2,3,4"},
                                                             {tint, "1,,3"},
                                                             {place, "1"},
                                                             {place, "nan,0,0"}}) {
        CAPTURE(knob.name, wrong);
        CHECK_FALSE(value(knob, wrong));
    }
}

}  // namespace candelabra
