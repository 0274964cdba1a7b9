// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/rendered_ranges.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("numbers outside of a range are brought into it", "[reading]") {
    FieldValue value = Vec2(-1, 20);
    CHECK(bring_into(between(0, 10), {"a", "b", 3}, value) == 10);
    CHECK(std::get<Vec2>(value) == Vec2(3, 10));
    value = -2.0;
    CHECK(bring_into(at_least(0), {"a", "b", 0, true}, value) == 2);
    value = 5.0;
    bring_into(at_least(0), {"a", "b", 1}, value);
    CHECK(std::get<double>(value) == 5);
    value = 70'000.0;
    bring_into(between(-32768, 32767), {"a", "b", 0, false, false, 65536}, value);
    CHECK(std::get<double>(value) == 70'000 - 65536);
    value = 34.0;
    bring_into(between(2, 33), {"a", "b", 2, false, true}, value);
    CHECK(std::get<double>(value) == 2);
    value = 0.0;
    bring_into(above(0), {"a", "b", 1e-6, true}, value);
    CHECK(std::get<double>(value) == 1e-6);
}

TEST_CASE("what POV-Ray renders outside of a range is a warning", "[reading]") {
    const std::string text = GENERATE(
        "torus { -1, 0.3 }", "torus { 1, -0.3 }", "superellipsoid { <-0.5, 1> }",
        "sphere_sweep { linear_spline 2, -x, 0.3, x, 0.3 tolerance 0 }",
        "blob { threshold -1 sphere { 0, 1, 1 } }",
        "julia_fractal { <-.1, 0, -.8, 0> max_iteration 0 }", "polygon { 4, 0, x, x + y + z, y }",
        "fog { distance -3 } sphere { 0, 1 }", "global_settings { number_of_waves 0 }",
        "sphere { 0, 1 interior { ior -1 } }",
        "sphere { 0, 1 finish { reflection { 1 exponent 0 } } }",
        "fog { distance 3 turbulence 0.3 octaves 20 }",
        "camera { aperture -1 blur_samples 4 focal_point 0 location -z }",
        "camera { aperture 1 blur_samples 4 variance -1 location -z }",
        "camera { fisheye aperture 1 blur_samples 4 confidence 2 location -z }",
        "light_source { 9, 1 area_light x, y, 2, 2 adaptive -1 }",
        "plane { y, 0 pigment { julia <0.3, 0.2>, -5 } }",
        "plane { y, 0 pigment { mandel 10 exponent 34 } }",
        "plane { y, 0 pigment { magnet 1 julia <0.3, 0.2>, -3 } }",
        "plane { y, 0 pigment { spiral1 100000 } }",
        "plane { y, 0 pigment { bozo warp { black_hole 0, -1 } } }",
        "plane { y, 0 pigment { rgb 1 } normal { bozo accuracy -1 } }",
        "media { scattering { 5, 0.3 eccentricity 2 } }",
        "rainbow { direction z angle 10 width 0 color_map { [0 rgb x] [1 rgb y] } }",
        "rainbow { direction z angle 10 width 5 distance 0 color_map { [0 rgb x] [1 rgb y] } }",
        "global_settings { assumed_gamma 20 }", "global_settings { subsurface { samples 10, -1 } }",
        "global_settings { photons { count 9 gather 5, 0 } }",
        "global_settings { photons { count 9 max_trace_level 400 } }",
        "global_settings { subsurface { samples -1, 3 } }", "camera { location -z right 0 }",
        "camera { location -z up 0 look_at x }", "camera { orthographic direction 0 }",
        "camera { spherical location -z up 0 }", "camera { right x up x direction x }",
        "light_source { 9, 1 spotlight point_at 9 }",
        "fog { fog_type 2 distance 3 fog_alt 1 up 0 }",
        "rainbow { direction z angle 10 width 5 distance 9 }",
        "height_field { function 1, 1 { x } }",
        "cubic { <0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, "
        "0, 0, 0, 0, 0, 0, 1> }",
        "parametric { function { u } function { v } function { u } <0, 0>, <0, 1> }",
        "plane { y, 0 texture { average texture_map { [-1 pigment { rgb 1 }] [3 finish { }] } } }",
        "plane { y, 0 pigment { rgb 1 quick_color } }");
    INFO(text);
    const Script done = run("#version 3.7; " + text);
    INFO(done.text);
    CHECK(done.text.starts_with("warning"));
    CHECK(done.text.find("error") == std::string::npos);
}

TEST_CASE("what POV-Ray refuses is an error", "[reading]") {
    const std::string text =
        GENERATE("ovus { -1, 0.3 }", "poly { 1, <1, 0, 0, 0> }", "polygon { 2, 0, x }",
                 "sphere { 0, 1 interior { media { intervals 0 } } }", "plane { 0, 1 }",
                 "global_settings { radiosity { count 0 } }");
    INFO(text);
    CHECK(complaint(text).starts_with("error"));
}

}  // namespace candelabra
