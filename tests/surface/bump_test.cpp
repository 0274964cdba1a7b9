// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/bump.h"

#include "support/script.h"
#include "surface/normal_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Bump bump_of(const std::string& text) {
    const Script done = run("#version 3.7; plane { z, 0 " + text + " }");
    INFO(text << '\n' << done.text);
    REQUIRE(done.text.empty());
    return done.texture().normal;
}

}  // namespace

TEST_CASE("bumped normals are POV-Ray's", "[surface]") {
    // On the plane z = 0, seen from below, with 6 digits.
    struct Row {
        std::string text;
        Vec3 first, second;
    };
    const std::vector<Row> rows = {
        {"normal{bumps 0.6}", Vec3(-0.240431, 0.101871, -0.965306),
         Vec3(-0.174789, -0.099415, -0.979574)},
        {"normal{bumps 0.6 scale 0.3}", Vec3(-0.109950, 0.016330, -0.993803),
         Vec3(0.012612, -0.047526, -0.998790)},
        {"normal{bumps 0.6 scale <0.3,1,2> rotate <10,30,50> translate <1,2,3>}",
         Vec3(-0.578156, -0.630733, -0.517602), Vec3(-0.148696, -0.193925, -0.969682)},
        {"normal{bumps 0.6 scale 0.3 no_bump_scale}", Vec3(-0.269324, 0.040000, -0.962219),
         Vec3(0.037785, -0.142381, -0.989091)},
        {"normal{bumps 0.6 scale <0.3,1,2> rotate <10,30,50> no_bump_scale}",
         Vec3(-0.057557, -0.149316, -0.987113), Vec3(-0.088365, -0.140997, -0.986059)},
        {"normal{dents 2}", Vec3(-0.031820, 0.013482, -0.999403),
         Vec3(-0.027662, -0.015734, -0.999493)},
        {"normal{dents 2 noise_generator 1 scale .2}", Vec3(-0.007883, 0.004587, -0.999958),
         Vec3(0.050396, 0.068672, -0.996366)},
        {"normal{wrinkles 0.7}", Vec3(0.391922, 0.479116, -0.785395),
         Vec3(0.475308, 0.366625, -0.799793)},
        {"normal{quilted 1.5 control0 .3 control1 .8 translate .1}",
         Vec3(0.247211, 0.123606, -0.961045), Vec3(-0.335578, -0.201347, -0.920243)},
        {"normal{ripples 0.8 frequency 2 phase .3}", Vec3(-0.105746, 0.220327, -0.969677),
         Vec3(0.026928, 0.107571, -0.993833)},
        {"normal{waves 0.2 frequency 2 phase .3 scale .5}", Vec3(-0.100891, 0.012226, -0.994822),
         Vec3(-0.050419, 0.212101, -0.975946)},
        {"normal{facets size .3}", Vec3(-0.031977, 0.078768, -0.996380),
         Vec3(-0.031977, 0.078768, -0.996380)},
        {"normal{facets coords .5 size .3}", Vec3(-0.078822, -0.163161, -0.983446),
         Vec3(0.109545, 0.003871, -0.993974)},
        {"normal{facets coords .5 size .3 metric 1}", Vec3(0.147502, -0.231125, -0.961678),
         Vec3(0.017195, 0.071323, -0.997305)},
        {"normal{facets coords .5 size .3 metric 3 scale 2}", Vec3(-0.296321, -0.109031, -0.948845),
         Vec3(0.081800, -0.039443, -0.995868)},
        {"normal{bozo 0.6}", Vec3(-0.039708, 0.031028, -0.998729),
         Vec3(-0.000974, 0.001418, -0.999999)},
        {"normal{bozo 0.6 scale .2}", Vec3(0.003040, -0.014731, -0.999887),
         Vec3(-0.041036, 0.010799, -0.999099)},
        {"normal{bozo 0.6 scale <.2,.5,1> no_bump_scale}", Vec3(0.124950, 0.027461, -0.991783),
         Vec3(0.058610, 0.034185, -0.997695)},
        {"normal{granite 0.2 accuracy .1}", Vec3(0.015363, -0.010864, -0.999823),
         Vec3(0.004763, 0.020950, -0.999769)},
        {"normal{granite bump_size 0.3 scale 3}", Vec3(-0.053725, -0.201562, -0.978001),
         Vec3(0.079787, -0.215505, -0.973238)},
        {"normal{bozo 0.6 turbulence .5 scale 2}", Vec3(0.029314, 0.016110, -0.999440),
         Vec3(-0.020756, -0.029393, -0.999352)},
        {"normal{gradient x 1 slope_map{[0 <0,1>][.5 <1,1>][.5 <1,0>][1 <0,-1>]} scale .7}",
         Vec3(-0.257663, -0.000000, -0.966235), Vec3(-0.075346, -0.067161, -0.994893)},
        {"normal{checker 0.5 scale .7}", Vec3(0.514303, -0.727334, 0.454398),
         Vec3(-0.350083, -0.247546, -0.903417)},
        {"normal{average normal_map{[1 bumps .5][2 bozo .5 scale .5]} scale 2}",
         Vec3(-0.067286, 0.012572, -0.997654), Vec3(0.030909, -0.029509, -0.999087)},
        {"normal{gradient y normal_map{[0.2 bumps .5][.8 bozo .5 scale .5]} scale 2 translate 4*y}",
         Vec3(0.031054, -0.055336, -0.997985), Vec3(0.193023, -0.045231, -0.980151)},
        {"normal{function{sin(x*3)*.5+.5} .4}", Vec3(0.072025, -0.000346, -0.997403),
         Vec3(-0.038780, -0.000697, -0.999248)},
        {"normal{marble 0.3 turbulence .4 scale .5}", Vec3(-0.100273, 0.023491, -0.994683),
         Vec3(0.015138, 0.013538, -0.999794)},
        {"normal{crackle 0.6 scale .5}", Vec3(0.132799, -0.020661, -0.990928),
         Vec3(-0.016465, 0.059709, -0.998080)},
        {"normal{ripples 0.8 slope_map{[0 <0,1>][1 <1,1>]}}", Vec3(0.092542, 0.104973, -0.990160),
         Vec3(-0.023745, -0.131118, -0.991082)},
        {"normal{bumps 0.6 scale .5} scale 2 rotate 20*z", Vec3(-0.170648, -0.047388, -0.984192),
         Vec3(-0.097340, -0.149803, -0.983913)},
    };
    const Vec3 normal(0, 0, -1);
    for (const Row& row : rows) {
        INFO(row.text);
        const Bump bump = bump_of(row.text);
        const Vec3 first = bumped(bump, normal, Vec3(-1.2, 0.7, 0));
        const Vec3 second = bumped(bump, normal, Vec3(0.35, -1.55, 0));
        CHECK(max_abs_component(first - row.first) < 2e-6);
        CHECK(max_abs_component(second - row.second) < 2e-6);
    }
}

TEST_CASE("a slope map is a cubic curve between its stops", "[surface]") {
    const SlopeMap map = {{0, 0, 1}, {0.5, 1, 0}, {0.5, 2, 0}, {1, 2, 0}};
    CHECK(look_up(map, -1) == 0);
    CHECK(look_up(map, 0) == 0);
    CHECK(look_up(map, 0.25) == Approx(0.5 + 1.0 / 8));
    CHECK(look_up(map, 0.5) == 1);
    CHECK(look_up(map, 0.75) == Approx(2));
    CHECK(look_up(map, 3) == 2);
}

TEST_CASE("a surface without a pattern is smooth", "[surface]") {
    CHECK(bumped(Bump(), Vec3(0, 1, 0), Vec3(1, 2, 3)) == Vec3(0, 1, 0));
    CHECK(nesting(Bump()).depth == 0);
}

TEST_CASE("a list of normals stands for its places", "[surface]") {
    const Bump bump = bump_of("normal { checker normal { bumps 1 } normal { bumps 0 } }");
    const Vec3 normal(0, 0, -1);
    CHECK(bumped(bump, normal, Vec3(1.5, 0.5, 0.5)) == normal);
    CHECK(bumped(bump, normal, Vec3(0.3, 0.5, 0.5)) != normal);
}

}  // namespace candelabra
