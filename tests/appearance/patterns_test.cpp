// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/patterns.h"

#include "pattern/values.h"
#include "support/scripts.h"
#include "surface/pigment_map.h"

namespace candelabra {

namespace {

std::string pattern_complaint(const std::string& text) {
    return complaint("sphere { 0, 1 pigment { " + text + " } }");
}

/// A scene with a file of 1 x 1 x 2 values.
Script with_file(const std::string& text) {
    using namespace std::string_literals;
    return run("#version 3.7; sphere { 0, 1 pigment { " + text + " } }",
               {{"a.df3", "\0\1\0\1\0\2\x80\xff"s}, {"b.df3", "\0\1"s}});
}

}  // namespace

TEST_CASE("a pattern has its values, modifiers and wave in any order", "[appearance]") {
    const PatternUse use = pattern_of(
        "spiral1 7 sine_wave turbulence <1, 2, 3> octaves 4 omega 0.25 lambda 3 frequency 2 "
        "phase 0.5 noise_generator 3");
    CHECK(std::get<Spiral1>(use.pattern).arms == 7);
    CHECK(std::holds_alternative<SineWave>(use.wave));
    CHECK(use.modifiers == PatternModifiers{Vec3(1, 2, 3), 4, 0.25, 3, 3, 2, 0.5});
    CHECK(pattern_of("bozo turbulence 0.5").modifiers.turbulence == Vec3(0.5));
}

TEST_CASE("a function is a pattern", "[appearance]") {
    const PatternUse use = pattern_of("function { x + 2 * y } sine_wave scale 2");
    CHECK(evaluate(std::get<FunctionPattern>(use.pattern), Vec3(0.25, 0.125, 9)) == 0.5);
    CHECK(std::holds_alternative<SineWave>(use.wave));
    CHECK(pattern_complaint("function (a) { a }").find("makes one number of x, y and z") !=
          std::string::npos);
    CHECK(pattern_complaint("function { pigment { rgb 1 } }").find("makes one number") !=
          std::string::npos);
}

TEST_CASE("a word of a pattern may be the name of another", "[appearance]") {
    const auto magnet = std::get<Magnet>(pattern_of("magnet 2 julia <1, 2>, 30").pattern);
    CHECK(magnet.type == 2);
    CHECK(magnet.julia == Vec2(1, 2));
    CHECK(magnet.julia_iterations == 30);
    CHECK(std::get<Magnet>(pattern_of("magnet 1 mandel 40").pattern).mandel == 40);
}

TEST_CASE("values stand behind the value of a word", "[appearance]") {
    const auto mandel =
        std::get<Mandel>(pattern_of("mandel 30 exterior 2, 0.5 interior 6, 3 exponent 4").pattern);
    CHECK(mandel.iterations == 30);
    CHECK(mandel.exterior == 2);
    CHECK(mandel.exterior_factor == 0.5);
    CHECK(mandel.interior == 6);
    CHECK(mandel.interior_factor == 3);
    CHECK(mandel.exponent == 4);
    const auto slope = std::get<Slope>(pattern_of("slope { y, 0.1, 0.9 altitude z, 1 }").pattern);
    CHECK(slope.high == 0.9);
    CHECK(slope.altitude == Vec3(0, 0, 1));
    CHECK(slope.altitude_low == 1);
    CHECK(slope.altitude_high == 0);
}

TEST_CASE("warps have their place among the transformations", "[appearance]") {
    const PatternUse use = pattern_of(
        "bozo scale 2 warp { repeat 3*y offset x flip y } warp { black_hole x, 2 strength 3 "
        "falloff 4 inverse } translate x rotate y warp { toroidal major_radius 2 } scale 3");
    REQUIRE(use.steps.size() == 6);
    CHECK(std::holds_alternative<Transform>(use.steps[0]));
    const auto& repeat = std::get<RepeatWarp>(std::get<Warp>(use.steps[1]));
    CHECK(repeat.width == Vec3(0, 3, 0));
    CHECK(repeat.offset == Vec3(1, 0, 0));
    const auto& hole = std::get<BlackHole>(std::get<Warp>(use.steps[2]));
    CHECK(hole.radius == 2);
    CHECK(hole.strength == 3);
    CHECK(hole.falloff == 4);
    CHECK(hole.inverse);
    CHECK(std::holds_alternative<Transform>(use.steps[3]));
    CHECK(std::get<ToroidalWarp>(std::get<Warp>(use.steps[4])).major_radius == 2);
}

TEST_CASE("a density file is found and read", "[appearance]") {
    const Script done = with_file("density_file df3 \"a.df3\" interpolate 1");
    CHECK(done.text.empty());
    const auto& file = std::get<DensityFile>(done.texture().pigment.pattern->use.pattern);
    CHECK(evaluate(file, {0.5, 0.5, 0}) == Approx(128.0 / 255));
    CHECK(with_file("density_file df3 \"c.df3\"").said.front().message ==
          "there is no file `c.df3`");
    CHECK(with_file("density_file df3 \"b.df3\"").said.front().message ==
          "`b.df3` is no file of format df3");
}

TEST_CASE("wrong patterns are told of once", "[appearance]") {
    const auto [text, expected] = GENERATE(table<std::string, std::string>({
        {"bozo turbulence", "error missing: `turbulence` of `pigment` needs a vector"},
        {"bozo turbulence scale 2", "error missing: `turbulence` of `pigment` needs a vector"},
        {"spiral1", "error missing: `spiral1` needs `arms`"},
        {"spiral1 0.5",
         "warning no-effect: `arms` of `pigment` is a whole number, and 0.5 counts as 0"},
        {"tiling 28", "error out-of-range: `type` of `pigment` must be from 1 to 27, but it is 28"},
        {"pavement number_of_sides 5",
         "error out-of-range: `number_of_sides` of `pavement` must be 3, 4 or 6, but it is 5"},
        {"pavement number_of_tiles 6 number_of_sides 6",
         "error out-of-range: `number_of_tiles` of `pavement` must be from 1 to 5 for "
         "`number_of_sides 6`, but it is 6"},
        {"pavement number_of_tiles 0",
         "error out-of-range: `number_of_tiles` of `pavement` must be from 1 to 6 for "
         "`number_of_sides 3`, but it is 0"},
        {"pavement number_of_sides 4 number_of_tiles 3 pattern 3",
         "error out-of-range: `pattern` of `pavement` must be from 1 to 2 for `number_of_sides 4 "
         "number_of_tiles 3`, but it is 3"},
        {"pavement pattern 0",
         "error out-of-range: `pattern` of `pavement` must be 1 for `number_of_sides 3 "
         "number_of_tiles 1`, but it is 0"},
        {"mandel 9 exterior 1",
         "error missing: the second value of `exterior` is missing, a number"},
        {"mandel 9 exponent 50",
         "warning no-effect: `exponent` of `pigment` should be from 2 to 33, but it is 50: 2 "
         "counts"},
        {"density_file", "error missing: `density_file` needs the name of a file"},
        {"facets size 1", "error misplaced: `facets` is for normals only"},
        {"slope { }", "error missing: `slope` needs a direction, or `point_at`"},
        {"pigment_pattern", "error missing: `pigment_pattern` needs a pigment in braces"},
        {"bozo warp { }", "error missing: `warp` needs the name of a kind"},
        {"bozo warp { repeat <1, 2, 0> }",
         "error out-of-range: `width` of `repeat` must lie along one axis, and not be 0"},
        {"bozo warp { black_hole 0, -1 }",
         "warning no-effect: `radius` of `warp` should be above 0, but it is -1: 1 counts"},
        {"bozo warp { displace 3 }", "error unknown-name: nothing is declared as `displace`"},
        {"wod", "error unknown-word: `pigment` has no word `wod`"},
        {"image_pattern { png \"x.png\" }", "error include-not-found: there is no file `x.png`"},
        {"image_pattern", "error missing: `image_pattern` needs a picture in braces"},
        {"bump_map { png \"x.png\" }", "error include-not-found: there is no file `x.png`"},
        {"bump_map { function 2, 2 { x } }", "error misplaced: `bump_map` is for normals only"},
    }));
    INFO(text);
    CHECK(pattern_complaint(text) == expected);
}

TEST_CASE("an object is a pattern, and the list stands in its braces", "[appearance]") {
    const SharedWorld world = world_of(
        "#declare Thing = union { sphere { 0, 1 } sphere { 3*x, 1 } }"
        "plane { y, 0 pigment { object { Thing rgb <1, 0, 0>, rgb <0, 1, 0> } } }"
        "plane { y, 0 pigment { object { sphere { 0, 1 } } scale 2 } }"
        "plane { y, 0 texture { object { Thing texture { pigment { rgb 0 } },"
        "  texture { pigment { rgb 1 } } } } }");
    const Texture& plain = *world->appearance.materials[0].texture;
    CHECK(evaluate(plain.pigment, Vec3(3.5, 0, 0)).rgb == Rgb(0, 1, 0));
    CHECK(evaluate(plain.pigment, Vec3(1.5, 0, 0)).rgb == Rgb(1, 0, 0));
    CHECK(evaluate(world->appearance.materials[1].texture->pigment, Vec3(1.5, 0, 0)).rgb ==
          Rgb(0, 1, 0));
    CHECK(world->appearance.materials[2].texture->choice);
}

}  // namespace candelabra
