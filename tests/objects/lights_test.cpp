// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/lights.h"

#include "photometry/light_colour.h"
#include "support/script.h"

#include <catch2/catch.hpp>

#include <numbers>
#include <regex>

namespace candelabra {

namespace {

const PointLight& light(const Script& done, std::size_t i = 0) {
    return done.scene.lights.at(i).light;
}

}  // namespace

TEST_CASE("a light source has its place, colour and words", "[objects]") {
    const Script done =
        run("#version 3.7; light_source { <1, 2, 3>, rgb <1, 0.5, 0> fade_distance 2 fade_power 1 "
            "shadowless } light_source { 0 } light_source { x 2 scale 3 }");
    REQUIRE(done.text.empty());
    CHECK(light(done).location == Vec3(1, 2, 3));
    CHECK(light(done).colour == Rgb(1, 0.5, 0));
    CHECK(light(done).fade_distance == 2);
    CHECK(light(done).shadowless);
    CHECK(light(done, 1).colour == Rgb(0));
    CHECK(light(done, 2).location == Vec3(3, 0, 0));
    CHECK(done.scene.objects.empty());
}

TEST_CASE("an intensity makes a light of nature, whose colour is a hue", "[objects]") {
    // 1000 cd at 2 m give 250 lx, which a surface shows as 250 / (200 pi).
    const Script done =
        run("#version 3.7; global_settings { photometry { unit 0.5 } } light_source { 0, rgb 7 "
            "intensity candela(1000) } light_source { 0 intensity candela(1000) } light_source { "
            "0, rgb "
            "kelvin(2700) flux lumen(12566.3706144) }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    for (std::size_t i = 0; i < 3; ++i) {
        const Rgb colour = incidence(light(done, i), Vec3(0), Vec3(0, -4, 0)).colour;
        CHECK(light_luminance(colour) == Approx(250 / (200 * std::numbers::pi)).epsilon(1e-9));
        if (i < 2) CHECK(colour.r == Approx(colour.b));
    }
    CHECK(light(done, 2).colour.r > light(done, 2).colour.g);
}

TEST_CASE("the flux of a spotlight fills its cone", "[objects]") {
    // A cone without a soft edge of half angle 60 degrees fills pi steradians.
    const Script done =
        run("#version 3.7; light_source { 0, 1 spotlight point_at z radius 60 falloff 60 flux 5 } "
            "light_source { 0, 1 spotlight point_at z radius 0 falloff 90 tightness 3 flux 5 }");
    REQUIRE(done.text.empty());
    CHECK(light(done, 0).colour.g == Approx(5 / std::numbers::pi).epsilon(1e-3));
    // The edge is soft all the way: the integral of c^3 (3 c^2 - 2 c^3) over the cosine.
    CHECK(light(done, 1).colour.g ==
          Approx(5 / (2 * std::numbers::pi * (1.0 / 2 - 2.0 / 7))).epsilon(1e-6));
}

TEST_CASE("a light may be dimmed to nothing", "[objects]") {
    for (const char* light :
         {"light_source { 0, rgb 1 intensity 0 }", "light_source { 0, rgb 1 flux 0 }",
          "light_source { 0, rgb 0 intensity 5 }", "light_source { 0, 0 flux 5 }",
          "#declare L = light_source { 0, rgb 0 flux 5 } light_source { L translate y }"}) {
        CAPTURE(light);
        const Script done = run(std::string("#version 3.7; ") + light);
        REQUIRE(done.text.empty());
        CHECK(done.scene.lights.at(0).light.colour == Rgb(0));
    }
    CHECK(run("#version 3.7; sphere { 0, 1 pigment { rgb 1 } luminaire { flux 0 } }").text.empty());
}

TEST_CASE("an intensity that cannot be is refused", "[objects]") {
    for (const char* const words :
         {"intensity 3 flux 3", "intensity 3 parallel", "flux 2 cylinder point_at x",
          "intensity 2 fade_distance 3", "intensity -1", "flux -1"}) {
        CAPTURE(words);
        const Script done = run(std::string("#version 3.7; light_source { y, 1 ") + words + " }");
        CHECK(done.text.find("error") != std::string::npos);
    }
}

TEST_CASE("of shadowless and kinds with shadows the last word holds, as in POV-Ray", "[objects]") {
    const Script done = run(
        "#version 3.7; light_source { y, 1 shadowless spotlight } light_source { y, 1 spotlight "
        "shadowless } #declare L = light_source { y, 1 shadowless } light_source { L cylinder }"
        "light_source { y, 1 shadowless cylinder shadowless parallel }");
    REQUIRE(done.scene.lights.size() == 4);
    CHECK_FALSE(light(done, 0).shadowless);
    CHECK(done.text.find("`shadowless` has no effect") != std::string::npos);
    CHECK(light(done, 1).shadowless);
    CHECK_FALSE(light(done, 2).shadowless);
    CHECK(light(done, 3).shadowless);
}

TEST_CASE("declared lights are placed anew", "[objects]") {
    const Script done =
        run("#version 3.7; #declare L = light_source { x, 1 } light_source { L translate x } "
            "object { L translate y } L");
    INFO(done.text);
    REQUIRE(done.text.empty());
    CHECK(light(done, 0).location == Vec3(2, 0, 0));
    CHECK(light(done, 1).location == Vec3(1, 1, 0));
    CHECK(light(done, 2).location == Vec3(1, 0, 0));
}

TEST_CASE("lights in unions move with them", "[objects]") {
    const Script done = run(
        "#version 3.7; #declare Lamp = union { sphere { 0, 1 } light_source { y, 1 } translate x } "
        "object { Lamp translate x } union { object { Lamp scale 2 } Lamp translate z } object { "
        "Lamp pigment { rgb 1 } }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    REQUIRE(done.scene.lights.size() == 4);
    CHECK(light(done, 0).location == Vec3(2, 1, 0));
    CHECK(light(done, 1).location == Vec3(2, 2, 1));
    CHECK(light(done, 2).location == Vec3(1, 1, 1));
    CHECK(light(done, 3).location == Vec3(1, 1, 0));
    CHECK(done.scene.objects.size() == 3);
}

TEST_CASE("wrong lights are told of once", "[objects]") {
    CHECK(complaint("light_source { }") == "error missing: `light_source` needs `location`");
    CHECK(complaint("light_source { 0, 1 no_shadow }") ==
          "error misplaced: `no_shadow` has no place in `light_source`");
    CHECK(complaint("light_source { 0, 1 area_light x, y, 2 }") ==
          "error missing: the fourth value of `area_light` is missing, a whole number");
}

TEST_CASE("a light that points at its own place lights nothing, as in POV-Ray", "[objects]") {
    const std::string kind = GENERATE("spotlight", "cylinder", "parallel", "spotlight parallel");
    const std::string text = "light_source { x, 1 " + kind + " point_at x }";
    CHECK(complaint(text) ==
          "warning degenerate: this light lights nothing: `point_at` is its own location");
    const Script done = run("#version 3.7; " + text);
    REQUIRE(done.scene.lights.size() == 1);
    CHECK(done.scene.lights[0].light.colour == Rgb(0));
}

TEST_CASE("a light may look like an object, which moves with it", "[objects]") {
    const Script done =
        run("#version 3.7; light_source { <1, 2, 3>, 1 area_light x, y, 4, 3 adaptive 1 jitter "
            "looks_like { sphere { 0, 1 } } translate 5*x }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    CHECK(light(done).size2 == 3);
    CHECK(light(done).location == Vec3(6, 2, 3));
    REQUIRE(done.scene.objects.size() == 1);
    CHECK(done.object().transform->point(Vec3(0)) == Vec3(6, 2, 3));
    CHECK(done.object().no_shadow);
}

TEST_CASE("a light source may be a declared object with lights in it", "[objects]") {
    const std::string script =
        "#version 3.7; #declare U = union { sphere { 0, 1 } light_source { y, 1 } }"
        "#declare O = object { light_source { z, 1 } } #declare A = array[2] { U, O }"
        "light_source { U translate x } light_source { O scale 2 } light_source { A[1] }"
        "union { light_source { A[0] translate -x } sphere { 9, 1 } }"
        "#declare X = light_source { U pigment { rgb x } no_shadow } object { X }"
        "#declare S = sphere { 0, 1 } light_source { S }";
    const Script done = run(script);
    INFO(done.text);
    REQUIRE(done.text.empty());
    REQUIRE(done.scene.lights.size() == 5);
    CHECK(light(done, 0).location == Vec3(1, 1, 0));
    CHECK(light(done, 1).location == Vec3(0, 0, 2));
    CHECK(light(done, 2).location == Vec3(0, 0, 1));
    CHECK(light(done, 3).location == Vec3(-1, 1, 0));
    CHECK(light(done, 4).location == Vec3(0, 1, 0));
    const Script plain =
        run(std::regex_replace(script, std::regex("light_source \\{ (U|O|S|A)"), "object { $1"));
    CHECK(plain.text.empty());
    CHECK(plain.scene.lights.size() == 5);
    CHECK(done.scene.objects.size() == plain.scene.objects.size());
    CHECK(complaint("#declare S = sphere { 0, 1 } light_source { S fade_power 2 }") ==
          "error misplaced: `fade_power` has no place in `light_source`");
}

}  // namespace candelabra
