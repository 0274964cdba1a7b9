// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/textures.h"

#include "support/spheres.h"
#include "surface/default_maps.h"
#include "surface/pigment_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Pigment pigment_of(const std::string& text) {
    return sphere_with("pigment { " + text + " }",
                       "#declare Red = rgb x; #declare M = color_map { [0 rgb 0] [1 rgb 1] } "
                       "#declare P = pigment { gradient x color_map { [0 Red] [1 rgb 1] } } "
                       "#declare Plain = pigment { gradient x } "
                       "#declare Q = pigment_map { [0 P] [1 rgb 1] }")
        .texture()
        .pigment;
}

const ColourMap& colours_of(const Pigment& pigment) {
    return std::get<ColourMap>(pigment.pattern->map);
}

std::string pigment_complaint(const std::string& text) {
    return complaint("sphere { 0, 1 pigment { " + text + " } }");
}

}  // namespace

TEST_CASE("a pigment is one colour", "[appearance]") {
    CHECK(pigment_of("rgb 1").colour == Colour{Rgb(1)});
    CHECK(pigment_of("Red").colour == Colour{Rgb(1, 0, 0)});
    CHECK(pigment_of("color Red").colour == Colour{Rgb(1, 0, 0)});
    CHECK(pigment_of("Red filter 0.5").colour == Colour{Rgb(1, 0, 0), 0.5, 0});
    CHECK(pigment_of("red 1 green 0.5").colour == Colour{Rgb(1, 0.5, 0)});
    CHECK(pigment_of("color <1, 2, 3, 0.1, 0.2>").colour == Colour{Rgb(1, 2, 3), 0.1, 0.2});
    CHECK_FALSE(pigment_of("P rgb 1").pattern);
}

TEST_CASE("a pigment is a pattern with its colours", "[appearance]") {
    const Pigment checker = pigment_of("checker rgb 1, Red scale 2");
    CHECK(std::holds_alternative<Checker>(checker.pattern->use.pattern));
    CHECK(colours_of(checker) == ColourMap{{0, {Rgb(1)}}, {1, {Rgb(1, 0, 0)}}});
    CHECK(checker.transform.point(Vec3(1)) == Vec3(2));
    CHECK(colours_of(pigment_of("checker")) == default_map(Checker{}));
    CHECK(colours_of(pigment_of("checker Red"))[1] == default_map(Checker{})[1]);
    CHECK(colours_of(pigment_of("hexagon Red Red Red")).size() == 3);

    const Pigment gradient = pigment_of("gradient y color_map { [0.25 rgb 1] [1, Red] }");
    CHECK(std::get<Gradient>(gradient.pattern->use.pattern).direction == Vec3(0, 1, 0));
    CHECK(colours_of(gradient) == ColourMap{{0.25, {Rgb(1)}}, {1, {Rgb(1, 0, 0)}}});
    CHECK(colours_of(pigment_of("gradient y")) == default_map(Gradient{}));
    CHECK(colours_of(pigment_of("gradient y colour_map { M }")) ==
          ColourMap{{0, {Rgb(0)}}, {1, {Rgb(1)}}});
    CHECK(colours_of(pigment_of("gradient y color_map { [0, 0.5 rgb 1 color Red] }")) ==
          ColourMap{{0, {Rgb(1)}}, {0.5, {Rgb(1, 0, 0)}}});
    CHECK(colours_of(pigment_of("P gradient y")) == ColourMap{{0, {Rgb(1, 0, 0)}}, {1, {Rgb(1)}}});
    // A map that is given is kept by other patterns, a default map is not.
    CHECK(colours_of(pigment_of("P bozo")) == colours_of(pigment_of("P gradient y")));
    CHECK(colours_of(pigment_of("P checker")) == default_map(Checker{}));
    CHECK(colours_of(pigment_of("Plain bozo")) == default_map(Bozo{}));
    // Colours of lists need no word.
    CHECK(colours_of(pigment_of("checker <1, 0, 0>, 0.5")) ==
          ColourMap{{0, {Rgb(1, 0, 0)}}, {1, {Rgb(0.5), 0.5, 0.5}}});
}

TEST_CASE("what is declared can be changed on", "[appearance]") {
    const Pigment changed = pigment_of("P frequency 3 warp { turbulence 1 } scale 2");
    CHECK(changed.pattern->use.modifiers.frequency == 3);
    CHECK(changed.pattern->use.steps.size() == 1);
    CHECK(changed.transform.point(Vec3(1)) == Vec3(2));
    CHECK(colours_of(changed).size() == 2);
    const Pigment again = pigment_of("P translate x warp { turbulence 1 } scale 2");
    CHECK(again.pattern->use.steps.size() == 2);
}

TEST_CASE("a pigment map holds pigments", "[appearance]") {
    const Pigment pigment =
        pigment_of("wood pigment_map { [0.3 P scale 2] [0.5, checker Red Red] [1 rgb 0.5] }");
    const auto& map = std::get<PigmentMap>(pigment.pattern->map);
    REQUIRE(map.size() == 3);
    CHECK(map[0].value == static_cast<double>(0.3f));
    CHECK(map[0].pigment.transform.point(Vec3(1)) == Vec3(2));
    CHECK(colours_of(map[1].pigment)[1].colour == Colour{Rgb(1, 0, 0)});
    CHECK(map[2].pigment.colour == Colour{Rgb(0.5)});
    CHECK(std::get<PigmentMap>(pigment_of("wood pigment_map { Q }").pattern->map).size() == 2);
}

TEST_CASE("a scene has a noise generator and a number of waves", "[appearance]") {
    CHECK(run("#version 3.7;").scene.settings.noise_generator == 2);
    CHECK(run("#version 3.1;").scene.settings.noise_generator == 1);
    const GlobalSettings settings =
        run("#version 3.1; global_settings { noise_generator 3 number_of_waves 5 }").scene.settings;
    CHECK(settings.noise_generator == 3);
    CHECK(settings.number_of_waves == 5);
}

TEST_CASE("wrong pigments are told of once", "[appearance]") {
    CHECK(pigment_complaint("<1, 0, 0>") ==
          "error wrong-type: expected a colour, but this is a vector of 3");
    CHECK(pigment_complaint("0.5") == "error wrong-type: expected a colour, but this is a number");
    CHECK(pigment_complaint("\"red\"") == "error misplaced: a string has no place in `pigment`");
    CHECK(pigment_complaint("rgb 1 rgb 0") ==
          "error misplaced: a pigment has one colour or one pattern, and this is a second");
    CHECK(pigment_complaint("gradient x gradient y") ==
          "error misplaced: a pigment has one colour or one pattern, and this is a second");
    CHECK(pigment_complaint("color_map { [0 rgb 1] } gradient x") ==
          "error misplaced: `color_map` needs a pattern before it");
    CHECK(pigment_complaint("checker color_map { [0 rgb 1] }") ==
          "error misplaced: `checker` takes two colours, not a `color_map`");
    CHECK(pigment_complaint("checker rgb 1, rgb 0, rgb 1") ==
          "error wrong-count: `checker` takes 2 colours, but here is one more");
    CHECK(pigment_complaint("checker rgb 1 pigment { rgb 1 }") ==
          "error misplaced: the entries of a list are all colours or all pigments");
    CHECK(pigment_complaint("average color_map { [0 rgb 1] }") ==
          "error misplaced: `average` takes a `pigment_map`, not a `color_map`");
    CHECK(pigment_complaint("average") == "error missing: `average` needs a `pigment_map`");
    CHECK(pigment_complaint("average pigment_map { [0 rgb 1] }") ==
          "warning no-effect: the weights of `average` sum to 0: all are 1 instead");
    CHECK(pigment_complaint("average pigment_map { [-1 rgb 1] [2 rgb 0] }") == "nothing");
    CHECK(pigment_complaint("pigment_map { [0 rgb 1] }") ==
          "error misplaced: `pigment_map` needs a pattern before it");
    CHECK(pigment_complaint("bozo pigment_map { [rgb 1] }") ==
          "error missing: the entries of a map begin with a number");
    CHECK(pigment_complaint("bozo pigment_map { }") ==
          "error missing: `pigment_map` has no entries");
    CHECK(pigment_complaint("gradient") == "error missing: `gradient` needs `direction`");
    CHECK(pigment_complaint("gradient x color_map { }") ==
          "error missing: `color_map` has no entries");
    CHECK(pigment_complaint("gradient x color_map { [rgb 1] }") ==
          "error missing: an entry of `color_map` begins with a number");
    CHECK(pigment_complaint("gradient x color_map { [0] }") ==
          "error missing: an entry of `color_map` needs a colour");
    CHECK(pigment_complaint("gradient x color_map { [0 rgb 1 rgb 0] }") ==
          "error wrong-count: an entry of `color_map` has one colour for each number");
    CHECK(pigment_complaint("gradient x color_map { [0 <1, 2, 3>] }") ==
          "error wrong-type: expected a colour, but this is a vector of 3");
    CHECK(pigment_complaint("quick_color") ==
          "warning missing: `quick_color` should have a colour");
}

TEST_CASE("pigments within pigments without end are refused", "[appearance]") {
    CHECK(complaint("#declare P = pigment { rgb 1 } #for (I, 1, 16) #declare P = pigment { bozo "
                    "pigment_map { [0 P] [1 P] } } #end") == "nothing");
    CHECK(complaint("#declare P = pigment { rgb 1 } #for (I, 1, 17) #declare P = pigment { bozo "
                    "pigment_map { [0 P] [1 P] } } #end") ==
          "error recursion-limit: too many pigments are nested here: each level can double the "
          "work");
}

TEST_CASE("entries of average weigh 1 when they have no number", "[appearance]") {
    const Pigment pigment = pigment_of("average pigment_map { [gradient x] [3 bozo] }");
    const auto& map = std::get<PigmentMap>(pigment.pattern->map);
    CHECK(map[0].value == 1);
    CHECK(map[1].value == 3);
}

}  // namespace candelabra
