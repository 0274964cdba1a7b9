// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/normals.h"

#include "support/spheres.h"
#include "surface/normal_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Bump bump_of(const std::string& text) {
    return sphere_with(text,
                       "#declare N = normal { bumps 0.3 scale 2 } "
                       "#declare M = normal_map { [0 N] [1 bozo 2] } "
                       "#declare S = slope_map { [0 <0, 1>] [1 <1, 0>] }")
        .texture()
        .normal;
}

std::string normal_complaint(const std::string& text) {
    return complaint("sphere { 0, 1 normal { " + text + " } }");
}

}  // namespace

TEST_CASE("a normal is a pattern with an amount", "[appearance]") {
    const auto amount = [](const std::string& text) {
        return bump_of("normal { " + text + " }").pattern->settings.bump_size;
    };
    CHECK(amount("bumps") == 0.5);
    CHECK(amount("bumps 0.25") == 0.25);
    CHECK(amount("gradient x, 0.25") == 0.25);
    CHECK(amount("slope y 0.25") == 0.25);
    CHECK(amount("spiral1 5, 0.25") == 0.25);
    CHECK(amount("bumps bump_size 2") == 2);
    CHECK(amount("N 0.7") == 0.7);
    CHECK(amount("N") == 0.3);
    const Bump bump =
        bump_of("normal { wrinkles 0.1 accuracy 0.5 no_bump_scale turbulence 2 scale 3 }");
    CHECK(bump.pattern->settings.accuracy == 0.5);
    CHECK(bump.pattern->settings.no_bump_scale);
    CHECK(bump.pattern->use.modifiers.turbulence == Vec3(2));
    CHECK(bump.transform.point(Vec3(1)) == Vec3(3));
}

TEST_CASE("a normal stands wherever a pigment may", "[appearance]") {
    CHECK(bump_of("texture { normal { N } }").pattern != nullptr);
    CHECK(bump_of("texture { N }").pattern != nullptr);
    CHECK(bump_of("texture { N scale 2 } scale 3").transform.point(Vec3(1)) == Vec3(12));
    CHECK_FALSE(bump_of("pigment { rgb 1 }").pattern);
    CHECK(run("#version 3.7; #default { normal { bumps 2 } } sphere { 0, 1 }")
              .texture()
              .normal.pattern->settings.bump_size == 2);
}

TEST_CASE("the default normal's amount holds for patterns that follow", "[appearance]") {
    const auto after = [](const std::string& text) {
        return run("#version 3.7; #default { normal { bump_size 2 accuracy 0.1 } } sphere { 0, 1 " +
                   text + " }")
            .texture()
            .normal;
    };
    CHECK_FALSE(after("").pattern);
    CHECK(after("normal { bumps }").pattern->settings.bump_size == 2);
    CHECK(after("normal { bumps 1 }").pattern->settings.bump_size == 1);
    CHECK(after("normal { bumps 1 }").pattern->settings.accuracy == 0.1);
    const Bump map = after("normal { wood normal_map { [0 bumps] [1 dents 1] } }");
    const auto& entries = std::get<NormalMap>(map.pattern->map);
    CHECK(entries[0].bump.pattern->settings.bump_size == 2);
    CHECK(entries[1].bump.pattern->settings.bump_size == 1);
}

TEST_CASE("maps of slopes and normals", "[appearance]") {
    const Bump slopes = bump_of("normal { gradient x slope_map { S } }");
    const auto& slope_map = std::get<SlopeMap>(slopes.pattern->map);
    REQUIRE(slope_map.size() == 2);
    CHECK(slope_map[1].height == 1);
    CHECK(slope_map[0].slope == 1);
    const Bump normals =
        bump_of("normal { gradient x normal_map { [0 N] [1 bozo 2] [2 dents 2 scale 3] } }");
    const auto& normal_map = std::get<NormalMap>(normals.pattern->map);
    REQUIRE(normal_map.size() == 3);
    CHECK(normal_map[2].bump.pattern->settings.bump_size == 2);
    CHECK(nesting(normals).depth == 2);
    CHECK(bump_of("normal { gradient x normal_map { M } }").pattern);
}

TEST_CASE("wrong normals are told of once", "[appearance]") {
    const auto [text, expected] = GENERATE(table<std::string, std::string>({
        {"bumps x",
         "error wrong-type: `amount` of `normal` must be a number, but it is a vector "
         "of 3"},
        {"bumps bozo", "error misplaced: a normal has one pattern, and this is a second"},
        {"bumps accuracy 0",
         "warning no-effect: `accuracy` of `normal` should be above 0, but it is 0: 1e-06 counts"},
        {"slope_map { [0 <0, 1>] }", "error misplaced: `slope_map` needs a pattern before it"},
        {"bumps slope_map { [0] }",
         "error missing: an entry of `slope_map` needs a height and a slope"},
        {"bumps slope_map { }", "error missing: `slope_map` has no entries"},
        {"average", "error missing: `average` needs a `normal_map`"},
        {"average normal_map { [0 bumps] }",
         "warning no-effect: the weights of `average` sum to 0: all are 1 instead"},
        {"checker normal { bumps } normal { bumps } normal { bumps }",
         "error misplaced: this pattern takes 2 normals, but here is one more"},
    }));
    INFO(text);
    CHECK(normal_complaint(text) == expected);
}

}  // namespace candelabra
