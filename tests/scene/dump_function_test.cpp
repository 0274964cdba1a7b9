// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/dump_function.h"

#include "scene/dump.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::string declared_functions =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "#declare N = 3; #declare A = array[2] { 2, 5 }\n"
    "#declare f_torus = function { internal(74) } #declare f_noise3d = function { internal(76) }\n"
    "#declare G = function (a, b) { a*b + N/7 - A[1] } #declare S = spline { cubic_spline "
    "0, <1, 2, 3> 1, <4, 1, 2> 2, <0, 0.1, 0> 3, <1, 1, 1> }\n"
    "#declare P = function { pigment { bozo color_map { [0 rgb x] [1 rgb <0, 1, 0.3>] } } }\n"
    "#declare Q = function { pattern { crackle turbulence 0.3 scale 0.2 } }\n"
    "#declare R = function { spline { S } } #declare T = function { transform { rotate 20*y } }\n";

std::string text_of(const std::string& script) {
    const WrittenFunctions written;
    const Script done = run(script);
    INFO(done.text);
    CHECK(done.text.find("error") == std::string::npos);
    return dump(done.scene);
}

double function_value(const Scene& scene, const Vec3& at) {
    const auto& surface = std::get<Shared<Isosurface>>(std::get<Shape>(scene.objects[0]->form));
    return surface->function->value(std::array{at.x, at.y, at.z});
}

}  // namespace

TEST_CASE("functions are written so that they compile to the same", "[scene]") {
    const char* const bodies[] = {
        "x*x + y*y + z*z - 1",
        "-x/3 + y/(1+2) - 2/z - x/-7 + (x - y)/z",
        "pow(x, 1) + pow(y, 3) + pow(x, z) + pow(x + y, 2)",
        "select(x, y, z) + select(x - 0.1, y, z, 3) + min(x, y, z, 1) - max(x, 2)",
        "sum(i, 1, N, i*x) + prod(j, 1, 3, y + sum(k, j, 4, k*z)) + x",
        "(x < y & y > z | x = 1) + (x <= 0.1) + (x != y) + (z >= 2)",
        "sin(x) + atan2(y, z) + mod(x, 0.3) + div(y, 0.2) + abs(-z) + floor(x) + exp(-y)",
        "G(x, 2) + G(y, G(z, x)) + pi - N + A[0]",
        "f_torus(x, y, z, 1, 0.3) + 0.2*f_noise3d(x*5, y*5, z*5)",
        "P(x, y, z).grey + P(x, y, 0).green + Q(x, y, z) + P(x, 0, z).hf",
        "R(x).y + R(z).x + T(x, y, z).z",
        "u + v*2 - 1e-20*x + 1e300*1e300*0 + 0.1",
    };
    for (const std::string body : bodies) {
        const std::string script = declared_functions + "isosurface { function { " + body +
                                   " } contained_by { box { -2, 2 } } }";
        const std::string text = text_of(script);
        INFO(script << "\n" << text);
        CHECK(text.find("...") == std::string::npos);
        const Script first = run(script), again = run(text);
        INFO(again.text);
        REQUIRE(again.scene.objects.size() == 1);
        for (int i = 0; i < 20; ++i) {
            const Vec3 at(0.1 * i - 1, 0.37 - 0.07 * i, 0.13 * i * i - 0.9);
            const double a = function_value(first.scene, at), b = function_value(again.scene, at);
            CHECK((a == b || (std::isnan(a) && std::isnan(b))));
        }
        CHECK(text_of(text) == text);
    }
}

TEST_CASE("functions stand wherever a scene has them", "[scene]") {
    const char* const scenes[] = {
        "parametric { function { sin(u) } function { G(u, v) } function { v } 0, 1 contained_by { "
        "sphere { 0, 3 } } }",
        "sphere { 0, 1 pigment { function { x*N } color_map { [0 rgb 0] [1 rgb 1] } } normal { "
        "function { G(x, y) } 0.3 } }",
        "plane { y, 0 pigment { image_map { function 8, 4 { P(x, y, 0).red } } } }",
        "plane { y, 0 pigment { image_map { function 8, 4 { pigment { gradient x } } } } }",
        "height_field { function 8, 8 { x*y } water_level 0.1 }",
        "sphere { 0, 1 hollow interior { media { emission 1 density { function { Q(x, y, z) } } } "
        "} }",
        "sky_sphere { pigment { function { R(y).x } } } sphere { 0, 1 }",
        "union { isosurface { function { x - 0.1 } } sphere { 0, 1 } pigment { rgb 1 } }",
        "sphere { 0, 1 pigment { object { box { 0, 1 rotate 9*y } rgb x, rgb y } } }",
    };
    for (const std::string scene : scenes) {
        const std::string text = text_of(declared_functions + scene);
        INFO(scene << "\n" << text);
        CHECK(text.find("...") == std::string::npos);
        CHECK(text.find("/*") == std::string::npos);
        CHECK(text_of(text) == text);
    }
}

TEST_CASE("textures of several layers in maps are declared", "[scene]") {
    const std::string layers =
        "#declare L = texture { pigment { rgb 1 } } texture { pigment { function { G(x, y) } "
        "color_map { [0 rgbt 1] [1 rgbt 0.3] } } } "
        "#declare M = texture { pigment { rgb x } } texture { pigment { rgbt 0.5 } } ";
    const std::string text =
        text_of(declared_functions + layers +
                "sphere { 0, 1 texture { checker texture { L }, texture { M } } } plane { y, 0 "
                "texture { gradient y texture_map { [0.2 L] [1 M] } } }");
    INFO(text);
    CHECK(text.find("#declare Texture_2 = ") != std::string::npos);
    CHECK(text.find("#declare Texture_3 = ") == std::string::npos);
    CHECK(text_of(text) == text);
}

TEST_CASE("a function whose text was not kept is left open", "[scene]") {
    const Script done = run("#version 3.7; isosurface { function { x - 0.1 } }");
    CHECK(dump(done.scene).find("isosurface { function { ... }") != std::string::npos);
}

}  // namespace candelabra
