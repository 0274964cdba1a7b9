// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/textures.h"

#include "evaluate/script.h"

#include <catch2/catch.hpp>

namespace {

Pigment pigment_of(const std::string& text) {
    const Script done =
        run("#version 3.7; #declare Red = rgb x; #declare M = color_map { [0 rgb 0] [1 rgb 1] } "
            "#declare P = pigment { gradient x color_map { [0 Red] [1 rgb 1] } } sphere { 0, 1 "
            "pigment { " +
            text + " } }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    return done.texture().pigment;
}

std::string wrong(const std::string& text) {
    return complaint("sphere { 0, 1 pigment { " + text + " } }");
}

}  // namespace

TEST_CASE("a pigment is one colour", "[evaluate]") {
    CHECK(pigment_of("rgb 1").colour == Colour{Vec3(1)});
    CHECK(pigment_of("Red").colour == Colour{Vec3(1, 0, 0)});
    CHECK(pigment_of("color Red").colour == Colour{Vec3(1, 0, 0)});
    CHECK(pigment_of("Red filter 0.5").colour == Colour{Vec3(1, 0, 0), 0.5, 0});
    CHECK(pigment_of("red 1 green 0.5").colour == Colour{Vec3(1, 0.5, 0)});
    CHECK(pigment_of("color <1, 2, 3, 0.1, 0.2>").colour == Colour{Vec3(1, 2, 3), 0.1, 0.2});
    CHECK_FALSE(pigment_of("P rgb 1").pattern);
}

TEST_CASE("a pigment is a pattern with its colours", "[evaluate]") {
    const Pigment checker = pigment_of("checker rgb 1, Red scale 2");
    CHECK(std::holds_alternative<Checker>(*checker.pattern));
    CHECK(checker.map == ColourMap{{0, {Vec3(1)}}, {1, {Vec3(1, 0, 0)}}});
    CHECK(checker.transform.point(Vec3(1)) == Vec3(2));
    CHECK(pigment_of("checker").map == default_map(Checker{}));

    const Pigment gradient = pigment_of("gradient y color_map { [0.25 rgb 1] [1, Red] }");
    CHECK(std::get<Gradient>(*gradient.pattern).direction == Vec3(0, 1, 0));
    CHECK(gradient.map == ColourMap{{0.25, {Vec3(1)}}, {1, {Vec3(1, 0, 0)}}});
    CHECK(pigment_of("gradient y").map == default_map(Gradient{}));
    CHECK(pigment_of("gradient y colour_map { M }").map ==
          ColourMap{{0, {Vec3(0)}}, {1, {Vec3(1)}}});
    CHECK(pigment_of("gradient y color_map { [0, 0.5 rgb 1 color Red] }").map ==
          ColourMap{{0, {Vec3(1)}}, {0.5, {Vec3(1, 0, 0)}}});
    CHECK(pigment_of("P gradient y").map == ColourMap{{0, {Vec3(1, 0, 0)}}, {1, {Vec3(1)}}});
}

TEST_CASE("wrong pigments are told of once", "[evaluate]") {
    CHECK(wrong("<1, 0, 0>") ==
          "error wrong-type: a colour must be said to be one, but this is a vector of 3");
    CHECK(wrong("0.5") ==
          "error wrong-type: a colour must be said to be one, but this is a number");
    CHECK(wrong("\"red\"") == "error misplaced: a string has no place in `pigment`");
    CHECK(wrong("rgb 1 rgb 0") ==
          "error misplaced: a pigment has one colour or one pattern, and this is a second");
    CHECK(wrong("gradient x gradient y") ==
          "error misplaced: a pigment has one colour or one pattern, and this is a second");
    CHECK(wrong("color_map { [0 rgb 1] } gradient x") ==
          "error misplaced: `color_map` needs a pattern before it");
    CHECK(wrong("checker color_map { [0 rgb 1] }") ==
          "error misplaced: `checker` takes two colours, not a `color_map`");
    CHECK(wrong("checker rgb 1, rgb 0, rgb 1") ==
          "error wrong-count: `checker` takes 2 colours, but here is one more");
    CHECK(wrong("gradient") == "error missing: `pigment` needs `direction`");
    CHECK(wrong("gradient x color_map { }") == "error missing: `color_map` has no entries");
    CHECK(wrong("gradient x color_map { [rgb 1] }") ==
          "error missing: an entry of `color_map` begins with a number");
    CHECK(wrong("gradient x color_map { [0] }") ==
          "error missing: an entry of `color_map` needs a colour");
    CHECK(wrong("gradient x color_map { [0 rgb 1 rgb 0] }") ==
          "error wrong-count: an entry of `color_map` has one colour for each number");
    CHECK(wrong("gradient x color_map { [0 <1, 2, 3>] }") ==
          "error wrong-type: a colour must be said to be one, but this is a vector of 3");
    CHECK(wrong("quick_color rgb 1") ==
          "warning no-effect: `quick_color` has no effect in this version");
}
