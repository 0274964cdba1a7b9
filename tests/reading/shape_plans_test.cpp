// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/shape_plans.h"

#include "scene/dump.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

constexpr const char* start =
    "#version 3.7; #declare R = seed(1); #declare T = texture { pigment { rgb 0.5 } } #declare U = "
    "texture { pigment { checker } } #declare A = array[12] {1,2,3,4,5,6,7,8,9,10,11,12} ";

std::string looped(const std::string& body, int passes) {
    return start + ("#for (I, 1, " + std::to_string(passes) + ") " + body) + " #end";
}

std::string unrolled(const std::string& body, int passes) {
    std::string script = start;
    for (int i = 1; i <= passes; ++i) script += "#declare I = " + std::to_string(i) + "; " + body;
    return script;
}

}  // namespace

TEST_CASE("a loop makes the objects that its passes make one by one", "[reading]") {
    const std::string body = GENERATE(
        as<std::string>(), "sphere { I*x, 1 }", "sphere { <rand(R), rand(R), I>, rand(R) }",
        "sphere { I, I pigment { rgb 1 } }", "sphere { I, 1 texture { T } }",
        "sphere { I, 1 texture { T } no_shadow rotate 10*y translate x }",
        "sphere { I, 1 #if (I > 3) pigment { rgb I } #end }",
        "#declare T = texture { pigment { rgb I } } sphere { I, 1 texture { T } }",
        "#if (mod(I, 3) = 0) #declare T = texture { U rotate I } #end sphere { I, 1 texture { T } "
        "}",
        "#if (I = 5) #default { pigment { rgb 1 } } #end sphere { I, 1 finish { phong 1 } }",
        "sphere { I, 1 pigment { rgb rand(R) } }", "sphere { I, 1 rotate I*y }",
        "sphere { I, 1 texture { pigment { rgb rand(R) } finish { phong 1 } } rotate y }",
        "sphere { I, 1 pigment { checker rgb I, rgb 0 } finish { phong 1 } rotate 20*y scale 2 }",
        "box { -I, I texture { pigment { checker rgb I, rgb 0 } scale 2 } rotate 20*y }",
        "sphere { I, 1 pigment { rgb I } hollow normal { bumps 1 } translate x }",
        "sphere { I, 1 rotate 9 pigment { rgb I } translate I*x }",
        "sphere { rand(R), 1 pigment { rgb rand(R) } rotate rand(R)*360 scale rand(R) + 1 }",
        "sphere { I, 1 texture { T } pigment { rgb I } }",
        "sphere { I, 1 texture { T pigment { rgb I } } }",
        "sphere { I, 1 texture { U pigment { rgb I } } }",
        "sphere { I, 1 texture { pigment { rgb I } } finish { phong 1 } }",
        "sphere { I, 1 pigment { rgb I } pigment { rgb 2*I } }",
        "#if (I = 5) #default { finish { phong I } } #end sphere { I, 1 pigment { rgb I } }",
        "#if (I = 5) #default { pigment { checker } } #end sphere { I, 1 pigment { rgb I } }",
        "box { -I, I pigment { #if (mod(I, 2)) checker #else rgb I #end } translate I }",
        "sphere { 0, 1 pigment { checker } translate I }",
        "sphere { 0, 1 clipped_by { plane { y, 0 } } translate I*x }",
        "sphere { A[I-1], A[mod(I, 4)] inverse }", "sphere { I, 1 clipped_by { box { -1, 1 } } }",
        "union { sphere { I, 1 } sphere { 2*I, 1 } pigment { rgb I } }",
        "sphere { I, 1 hollow interior { ior 1.5 } pigment { checker } scale 2 }",
        "cylinder { 0, I*x, 0.5 open pigment { rgb 1 } }", "box { -I, I translate I*x }",
        "disc { I, y, 2, 1 } disc { I, y, 2 }", "cone { 0, 1, I*y, 0 }", "torus { I + 1, 0.5 }",
        "triangle { 0, x, I*y pigment { rgb 1 } }",
        "smooth_triangle { 0, y, x, y, I*z, y texture { U } }", "superellipsoid { <I/10, 1> }",
        "plane { y, I } quadric { 1, 0, 0, I }", "torus { 2, 1 + I/10 sturm }",
        "difference { sphere { I, 1 } sphere { I + 1, 1 } pigment { rgb 1 } }",
        "intersection { sphere { -I, 1 } sphere { I, 1 } }",
        "#local Old = sphere { I, 1 texture { T } } object { Old rotate y }");
    INFO(body);
    const Evaluated loop = evaluated(looped(body, 12)), list = evaluated(unrolled(body, 12));
    REQUIRE_FALSE(loop.failed);
    CHECK(dump(loop.scene) == dump(list.scene));
}

TEST_CASE("a loop makes the combined objects that its passes make one by one", "[reading]") {
    const std::string body = GENERATE(
        as<std::string>(),
        "difference { box { -1, 1 } sphere { 0, 1.2 } pigment { rgb 1 } translate rand(R)*I }",
        "union { sphere { 0, 1 } light_source { y, 1 } pigment { rgb I } rotate I*y scale 2 }",
        "union { sphere { 0, 1 pigment { checker } } sphere { y, 1 } translate I*y }",
        "intersection { sphere { 0, 1 } box { 0, 1 } scale I / 20 no_shadow translate I*y }",
        "merge { sphere { 0, 1 } #if (I > 4) box { 0, 1 } #end translate I*y }");
    INFO(body);
    // Dumped one by one, because only the loop shares their parts.
    const auto objects = [](const Evaluated& evaluated) {
        std::string result;
        for (const ObjectHandle& object : evaluated.scene.objects) {
            Scene one;
            one.objects = {object};
            result += dump(one);
        }
        return result;
    };
    const Evaluated loop = evaluated(looped(body, 12)), list = evaluated(unrolled(body, 12));
    REQUIRE_FALSE(loop.failed);
    CHECK(objects(loop) == objects(list));
    CHECK(loop.scene.lights.size() == list.scene.lights.size());
}

TEST_CASE("a union's loop does, too", "[reading]") {
    const std::string body =
        GENERATE(as<std::string>(), "sphere { I, 1 }", "sphere { I, 1 texture { U } }",
                 "sphere { I, 1 inverse }", "sphere { I, 1 } box { 0, I }",
                 "#if (I = 4) light_source { I, 1 } #end sphere { <I, rand(R), 0>, 1 }",
                 "sphere { I, 1 #if (mod(I, 2)) no_shadow #end }", "triangle { 0, x, I*y }");
    INFO(body);
    const auto within = [&](const std::string& list) {
        return evaluated(start + ("union { " + list + " pigment { rgb 0.2 } translate x }"));
    };
    const std::size_t length = std::string(start).size();
    const Evaluated loop = within(looped(body, 9).substr(length));
    const Evaluated list = within(unrolled(body, 9).substr(length));
    REQUIRE_FALSE(loop.failed);
    CHECK(dump(loop.scene) == dump(list.scene));
}

TEST_CASE("values that do not fit are reported wherever the loop stands", "[reading]") {
    struct Case {
        const char* body;
        const char* said;
    };
    const auto [body, said] = GENERATE(values<Case>({
        {"sphere { I, 5 - I }", "this `sphere` is left out: its radius is 0"},
        {"sphere { I, 1 / (I - 5) }", "zero"},
        {"#if (I = 5) #undef A #end sphere { A[I], 1 }", "`A`"},
        {"#if (I = 5) #declare A = \"five\"; #else #declare A = I; #end sphere { A, 1 }",
         "a string"},
        {"triangle { 0, x, (5 - I)*x }", "this `triangle` is left out"},
        {"sphere { rgb I, 1 }", "a colour"},
        {"sphere { rand(R), 1 pigment { rgb rand(R)/(I - 5) } }", "zero"},
        {"difference { sphere { 0, 1 } box { 0, 1 } scale <1, I - 5, 1> }", "taken as 1"},
        {"cylinder { 0, (5 - I)*x, 1 }", "cylinder"},
    }));
    INFO(body);
    CHECK_THAT(evaluated(looped(body, 9)).diagnostics, Catch::Contains(said));
}

}  // namespace candelabra
