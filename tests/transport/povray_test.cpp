// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/integrator.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <array>
#include <catch2/catch.hpp>
#include <numbers>
#include <tuple>

namespace candelabra {

namespace {

Rgb seen(const std::string& script, const Vec3& from = Vec3(0),
         const Vec3& direction = Vec3(0, 0, 1)) {
    const Shot shot = shot_of(script);
    return Integrator(shot, {}).radiance({from, unit(direction)}, Key());
}

}  // namespace

TEST_CASE("a ray that meets nothing sees the background", "[render]") {
    CHECK(seen("background { rgb <0.1, 0.2, 0.3> }") == Rgb(0.1, 0.2, 0.3));
}

TEST_CASE("facing mirrors show as many surfaces as the level allows", "[render]") {
    const std::string mirrors = R"(
        #declare Mirror = texture { pigment { rgb 1 } finish { ambient 1 diffuse 0 reflection 1 } }
        box { <-9, -9, 5>, <9, 9, 6> texture { Mirror } }
        box { <-9, -9, -6>, <9, 9, -5> texture { Mirror } }
        global_settings { max_trace_level )";
    for (const int level : {1, 3, 7})
        CHECK(seen(mirrors + std::to_string(level) + " }").r == Approx(level));
}

TEST_CASE("a camera ray whose rays multiply ends at a bound, the same each time", "[render]") {
    const std::string scene = R"(
        #version 3.7;
        global_settings { max_trace_level 256 adc_bailout 0 }
        light_source { <3, 4, -5>, 1 }
        sphere { 0, 1 pigment { rgbt 1 } finish { reflection 1 } interior { ior 1.2 } }
        box { -9, 9 pigment { rgbt 0.9 } finish { reflection 1 } interior { ior 1.5 } } )";
    const Shot shot = shot_of(scene);
    const auto traced = [&](const Shot& shot, std::uint64_t max_rays) {
        Integrator integrator(shot, {.max_rays = max_rays});
        const Rgb light = integrator.radiance({Vec3(0.1, 0.2, -3), Vec3(0, 0, 1)}, Key());
        return std::tuple(light, integrator.cut(), integrator.ledger().scattered);
    };
    const auto [light, cut, rays] = traced(shot, 5000);
    CHECK(cut);
    CHECK(rays >= 5000 - 1);
    CHECK(rays <= 2 * 5000 + 2 * 256);
    CHECK(traced(shot, 5000) == std::tuple(light, cut, rays));
    // The next ray has all of its rays.
    Integrator again(shot, {.max_rays = 5000});
    again.radiance({Vec3(0.1, 0.2, -3), Vec3(0, 0, 1)}, Key());
    CHECK(again.radiance({Vec3(0.1, 0.2, -3), Vec3(0, 0, 1)}, Key()) == light);
    // Rays that are not too many do not differ.
    const Shot lossy = shot_of(scene + "global_settings { max_trace_level 6 adc_bailout 1/255 }");
    CHECK_FALSE(std::get<1>(traced(lossy, 5000)));
    CHECK(traced(lossy, 5000) == traced(lossy, 1'000'000));
}

TEST_CASE("clear surfaces without refraction use up no level", "[render]") {
    const std::string panes = R"(
        #for (I, 1, 30) box { <-9, -9, I>, <9, 9, I + 0.5> pigment { rgbt 1 } } #end
        background { rgb 0.5 }
        global_settings { max_trace_level )";
    CHECK(seen(panes + "5 }").r == Approx(0.5));
    CHECK(seen(panes + "2 }").r == Approx(0.5));
    CHECK(seen(panes + "1 }").r == 0);  // but they need one to be left
}

TEST_CASE("a glass sphere turns the picture upside down", "[render]") {
    const std::string ball = R"(
        sphere { <0, 0, 5>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
        plane { z, 20 pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } scale 200 translate -100*y }
                finish { ambient 1 diffuse 0 } }
        global_settings { max_trace_level 10 })";
    CHECK(seen(ball, Vec3(0, 0.3, 0)).r < 0.5);
    CHECK(seen(ball, Vec3(0, -0.3, 0)).r > 0.5);
}

TEST_CASE("a negative transparency takes away what is behind", "[render]") {
    CHECK(length(seen("plane { -z, -5 pigment { rgb 0.5 transmit -1 } finish { ambient 0.8 "
                      "diffuse 0 } } background { rgb <0.2, 0.3, 0.1> }") -
                 Rgb(0.6, 0.5, 0.7)) < 1e-12);
}

TEST_CASE("filtered light takes the pigment's colour", "[render]") {
    CHECK(length(seen("box { <-9, -9, 5>, <9, 9, 6> pigment { rgbf <1, 0.5, 0, 1> } finish { "
                      "ambient 0 diffuse 0 } }"
                      "background { rgb 1 } global_settings { adc_bailout 0 }") -
                 Rgb(1, 0.25, 0)) < 1e-12);
}

TEST_CASE("of what is clear only the grey of each surface counts", "[render]") {
    const Shot shot = shot_of(
        "#version 3.7; box { <-9, -9, 5>, <9, 9, 6> pigment { rgbf <0.4, 0.8, 0.6, 0.5> } }");
    Tracing wanted;
    wanted.clear_sky = true;
    Integrator integrator(shot, wanted);
    integrator.radiance({Vec3(0), Vec3(0, 0, 1)}, Key());
    const double each = grey(0.5 * Rgb(0.4, 0.8, 0.6));
    CHECK(integrator.clear() == Approx(each * each));
}

TEST_CASE("bumps that turn away mirror and bend light as POV-Ray's do", "[render]") {
    // A plane seen at 5 degrees, with its normal tilted evenly by a slope map.
    struct Case {
        double slope;
        bool mirror;
        double povray;
    };
    for (const auto& [slope, mirror, povray] : {Case{-2, true, 0.54357},
                                                {-1, true, 0.54357},
                                                {1, true, 0.67256},
                                                {-8, false, 0.61567},
                                                {-4, false, 0.70414},
                                                {4, false, 0.26554}}) {
        CAPTURE(slope, mirror);
        const std::string script =
            "camera { location 9*y look_at z } sky_sphere { pigment { gradient y color_map { [0 "
            "rgb 0] [1 rgb 1] } scale 2 "
            "translate -y } } plane { y, 0 pigment { rgbt " +
            std::string(mirror ? "0" : "1") + " } finish { ambient 0 diffuse 0 reflection " +
            (mirror ? "1" : "0") + " } interior { ior 1.5 } normal { gradient x, " +
            std::to_string(slope) +
            " slope_map { [0 <0, 1>] [1 <1, 1>] } accuracy 0.0001 } translate 0.37*x }";
        const double angle = std::numbers::pi / 36;
        const Vec3 from(-5 * std::cos(angle), 5 * std::sin(angle), 0);
        CHECK(seen(script, from, -from).r == Approx(povray).margin(2e-3));
    }
}

TEST_CASE("a reflection's exponent takes in iridescence, and leaves out total reflection",
          "[render]") {
    const std::string glass = R"(camera { location -0.5*y look_at x }
        box { <-50, -1, -50>, <50, 0, 50> pigment { rgbf 1 }
              finish { ambient 0 diffuse 0 reflection { 0.6 exponent 2 } } interior { ior 1.5 } }
        box { <2, -0.99, -5>, <3, -0.01, 5> pigment { rgb <0.2, 0.4, 0.6> }
              finish { ambient 1 diffuse 0 } })";
    const Rgb wall = seen(glass, Vec3(0, -0.5, 0), Vec3(1, 0.5, 0));
    CHECK(length(wall - Rgb(0.2, 0.4, 0.6)) < 1e-9);

    const auto mirror = [](const std::string& exponent) {
        return seen(
            "background { rgb 0.6 } plane { y, 0 pigment { rgb 1 } finish { ambient 0 "
            "diffuse 0 reflection { 0.8 exponent " +
                exponent + " } irid { 0.5 thickness 0.3 turbulence 0 } } }",
            Vec3(0, 2, -3), Vec3(0, -2, 3));
    };
    const Rgb colours = mirror("1") / (0.8 * 0.6);
    CHECK(length(mirror("0.5") - 0.8 * (colours * 0.6) * (colours * 0.6)) < 1e-9);
}

TEST_CASE("the textures of a blob's components flow into each other as POV-Ray's do", "[render]") {
    const std::string blob = R"(#version 3.7;
        #default { finish { ambient 1 diffuse 0 } }
        blob {
            threshold 0.3
            sphere { -0.5*x, 1.5, 1 pigment { rgb x } }
            sphere { 0.5*x, 1.5, 1 pigment { rgb y } }
            cylinder { -y, y, 1.2, 1 pigment { rgb z } translate 0.3*x }
            sphere { y, 1.6, -0.5 }
            pigment { rgb 1 }
        )";
    const auto cases = std::array{// Light below adc_bailout is left out: here 0.0022 of white.
                                  std::pair{Vec3(-0.9, 0.1, -5), Rgb(0.9978, 0, 0)},
                                  std::pair{Vec3(-0.2, 0, -5), Rgb(0.7227, 0.3063, 0.0541)},
                                  std::pair{Vec3(0.3, 0.2, -5), Rgb(0.2328, 0.7175, 0.2712)},
                                  std::pair{Vec3(0.1, 0.6, -5), Rgb(0.4544, 0.5519, 0.5691)},
                                  std::pair{Vec3(0.7, -0.3, -5), Rgb(0, 0.8555, 0.1445)}};
    for (const std::string end : {"}", "clipped_by { sphere { 0, 9 } } }"})
        for (const auto& [from, colour] : cases)
            CHECK(max_abs_component(seen(blob + end, from) - colour) < 1e-4);
}

TEST_CASE("what a pattern gives a small share of is seen all the same", "[render]") {
    CHECK(seen("plane { -z, -5 texture { gradient x texture_map { [0 pigment { rgb 0 } ] "
               "[1 pigment { rgb 50 } finish { ambient 1 diffuse 0 }] } } }",
               Vec3(0.001, 0, 0))
              .r == Approx(0.05));
}

TEST_CASE("slopes in a patterned texture see the normal from outside, as POV-Ray's", "[render]") {
    const std::string ball = R"(#version 3.7;
        #default { finish { ambient 1 diffuse 0 } }
        sphere { 0, 1 texture { checker
            texture { pigment { slope <-0.979, 0.752, -0.766> color_map { [0 rgb 0] [1 rgb 1] } } }
            texture { pigment { slope y color_map { [0 rgb 0] [1 rgb 1] } }
                      normal { gradient x 0.001 } }
            rotate <-46.7, 82.6, 86.9> } })";
    const auto cases =
        std::array{std::pair{Vec3(-0.6, 0.1, -5), 0.8388}, std::pair{Vec3(-0.2, 0, -5), 0.7258},
                   std::pair{Vec3(0.3, 0.2, -5), 0.6286}, std::pair{Vec3(0.1, 0.6, -5), 0.3662},
                   std::pair{Vec3(0.7, -0.3, -5), 0.4079}};
    for (const auto& [from, brightness] : cases)
        CHECK(std::abs(seen(ball, from).r - brightness) < 2e-4);
}

namespace {

/// A camera that is in none of the solids.
const std::string away = "camera { location -500*z } ";

}  // namespace

TEST_CASE("what is left of light by solids in each other is POV-Ray's", "[render]") {
    const auto box = [](const char* from, const char* to, const std::string& inside) {
        return std::string("box { <-9, -9, ") + from + ">, <9, 9, " + to +
               "> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { " + inside + " } } ";
    };
    const std::string one = "fade_distance 2 fade_power 1001 fade_color <0.9, 0.5, 0.1>";
    const std::string two = "fade_distance 3 fade_power 1001 fade_color <0.2, 0.5, 0.8>";
    struct Case {
        std::string solids;
        Rgb seen, lit;  // by POV-Ray 3.7: transmittance for the view, and for light
    };
    const Case cases[] = {
        {box("0", "10", one) + box("3", "5", two),
         {0.4569, 0.2053, 0.0922},
         {0.5049, 0.3385, 0.2269}},
        {box("0", "10", one) + box("5", "14", two),
         {0.2680, 0.1471, 0.0807},
         {0.2053, 0.1245, 0.0755}},
        {box("0", "10", one) + box("5", "14", ""),
         {0.7788, 0.2865, 0.1054},
         {0.7788, 0.2865, 0.1054}},
        // The parts of a union share one interior: it ends where the second part begins.
        {"union { box { <-9, -9, 0>, <9, 9, 6> } box { <-9, -9, 4>, <9, 9, 10> } "
         "pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { " +
             one + " } }",
         {0.6703, 0.1353, 0.0273},
         {0.6703, 0.1353, 0.0273}},
    };
    for (const Case& c : cases) {
        const Rgb behind = seen(away + "background { rgb 1 } " + c.solids, Vec3(0, 0, -50));
        CHECK(max_abs_component(behind - c.seen) < 1e-4);
        const Rgb light = seen(away +
                                   "light_source { -50*z rgb 1 parallel point_at 0 } plane { z, 60 "
                                   "pigment { rgb 1 } finish { ambient 0 diffuse 1 } } " +
                                   c.solids,
                               Vec3(0, 0, 50));
        CHECK(max_abs_component(light - c.lit) < 1e-4);
    }
}

TEST_CASE("parts of a union that overlap bend light as in POV-Ray", "[render]") {
    const std::string rest =
        "box { <-99, -99, 0>, <99, 99, 6> } box { <-99, -99, 4>, <99, 99, 10> } "
        "pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } } "
        "plane { z, 30 pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 80 "
        "translate -40*x } finish { ambient 1 diffuse 0 } }";
    const Vec3 from(-34, 0, -50), towards(0.564642473395, 0, 0.82533561491);
    CHECK(seen(away + "union { " + rest, from, towards).r == Approx(0.7313).margin(1e-4));
    CHECK(seen(away + "merge { " + rest, from, towards).r == Approx(0.7244).margin(1e-4));
}

TEST_CASE(
    "radiosity counts the first surface for light of lamps, and not of light sources, as POV-Ray",
    "[render]") {
    // A light in the middle of a ball of radius 1: each reflection multiplies the radiance by 0.5.
    const std::string lamp =
        "sphere { 0, 0.01 pigment { rgb 1 } finish { diffuse 0 emission 1e4 } }";
    for (const std::string& light : {std::string("light_source { 0, rgb 1 }"), lamp})
        for (int limit = 1; limit <= 3; ++limit) {
            const Shot shot = shot_of(
                "#version 3.7; #default { finish { ambient 0 diffuse 1 } } "
                "global_settings { radiosity { recursion_limit " +
                std::to_string(limit) + " } } sphere { 0, 1 hollow pigment { rgb 0.5 } } " + light);
            Integrator integrator(shot, {});
            double sum = 0, expected = 0;
            Key key;
            for (key.sample = 0; key.sample < 2000; ++key.sample)
                sum += integrator.radiance({Vec3(0.3, 0.1, 0.2), unit(Vec3(3, 1, 2))}, key).r;
            const int reflections = limit + (light == lamp ? 0 : 1);
            for (int i = 1; i <= reflections; ++i) expected += std::pow(0.5, i);
            CAPTURE(light, limit);
            CHECK(sum / 2000 == Approx(expected).epsilon(0.01));
        }
}

}  // namespace candelabra
