// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/review.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string said_about(const std::string& script, bool surveyed) {
    Diagnostics diagnostics;
    const Scene scene = scene_of(script);
    const SharedWorld world =
        surveyed ? survey(scene, diagnostics) : compile(scene, {}, diagnostics);
    review(scene, *world, diagnostics);
    std::string said;
    for (const Diagnostic& each : diagnostics.all()) said += std::string(name(each.fault)) + ' ';
    return said;
}

}  // namespace

TEST_CASE("scenes in which nobody can see anything", "[world]") {
    struct Case {
        const char* script;
        const char* said;
    };
    const auto [script, said] = GENERATE(values<Case>({
        {"", "no-camera no-object "},
        {"camera { location -z } light_source { 0, 1 }", "no-object "},
        {"camera { location -z } sphere { 0, 1 }", "no-light "},
        {"camera { location -z } sphere { 0, 1 } light_source { 0, 1 }", ""},
        {"camera { location -z } sphere { 0, 1 finish { emission 1 } pigment { rgb 1 } }", ""},
        {"camera { location -z } sphere { 0, 1 finish { ambient 1 } }", ""},
        {"camera { location -z } sphere { 0, 0.5 } disc { 3*y, y, 1 texture { pigment { rgb 0 } } "
         "interior_texture { pigment { rgb 1 } finish { emission 5 } } }",
         ""},
        {"camera { location -z } sphere { 0, 1 } background { rgb 1 }", ""},
        {"camera { location -z } difference { sphere { 0, 1 } box { 0, 1 } }", "no-light "},
        {"camera { location -z } difference { sphere { 0, 1 } box { 0, 1 pigment { rgb 1 } "
         "finish { emission 1 } } }",
         ""},
        {"camera { location y } light_source { 0, 1 } plane { y, 0 pigment { rgb 1 } finish { "
         "emission 1 } }",
         "degenerate "},
        {"camera { location -z } light_source { 0, 1 } union { triangle { 0, x, 2*x } pigment { "
         "rgb 1 } finish { emission 1 } }",
         "no-object "},
        {"camera { location -z } light_source { 9, 1 } sphere { 9*z, 1 } plane { y, -5 pigment { "
         "rgbt 1 } hollow interior { media { emission 1 } luminaire } }",
         "degenerate "},
        {"light_source { 9*y, 1 } sphere { 0, 2 } camera { location z look_at 0 }",
         "camera-inside "},
        {"light_source { 9*y, 1 } sphere { 0, 2 hollow } camera { location z look_at 0 }", ""},
        {"light_source { 0, 1 } difference { sphere { 0, 3 } sphere { 0, 2 } } camera { location z "
         "look_at 0 }",
         ""},
        {"light_source { 0, 1 } box { 0, 1 rotate y translate z } camera { location "
         "<.6, .5, 1.2> }",
         "camera-inside "},
        {"light_source { 9*y, 1 } union { box { 3, 4 } sphere { 0, 2 } translate z } camera { "
         "location 2*z look_at 0 }",
         "camera-inside "},
        {"light_source { 0, 1 } union { box { 3, 4 } sphere { 0, 2 } translate 9*z } camera { "
         "location z look_at 0 }",
         ""},
        {"light_source { 9*y, 1 } #for (I, 1, 5) sphere { I*x, 0.4 } #end camera { location "
         "4*x look_at 0 }",
         "camera-inside "},
        {"light_source { 0, 1 } box { 3, 4 inverse } camera { location z look_at 0 }", ""},
        {"light_source { 10*y, 1 } intersection { box { 3, 4 inverse } sphere { 0, 9 } } camera { "
         "location z look_at 0 }",
         "camera-inside "},
        {"camera { location -z } light_source { 0, 1 } sphere { 0, 9 inverse no_image pigment { "
         "rgb "
         "1 } finish { emission 1 } }",
         "glowing-dome "},
        {"camera { location -z } light_source { 0, 1 } box { -9, 9 hollow no_image pigment { rgb "
         "1 } finish { emission 1 } }",
         "glowing-dome "},
        {"camera { location -z } light_source { 0, 1 } sphere { 0, 9 inverse no_luminaire pigment "
         "{ rgb 1 } finish { emission 1 } }",
         ""},
        {"global_settings { luminaires emission } camera { location -z } light_source { 0, 1 } "
         "sphere { 0, 9 inverse pigment { rgb 1 } finish { emission 1 } }",
         ""},
        {"#default { camera { location -z } } plane { y, -1 } light_source { 0, 1 }", "no-camera "},
    }));
    INFO(script);
    CHECK(said_about(script, false) == said);
    CHECK(said_about(script, true) == said);
}

TEST_CASE("a lamp without a pigment is told why it is dark", "[world]") {
    const auto help = [](const std::string& rest) {
        Diagnostics diagnostics;
        const Scene scene = scene_of("camera { location -z } " + rest);
        review(scene, *compile(scene, {}, diagnostics), diagnostics);
        REQUIRE(diagnostics.all().size() == 1);
        REQUIRE(diagnostics.all().front().fault == Fault::no_light);
        return diagnostics.all().front().help;
    };
    const std::string lamp = "sphere { 0, 1 finish { emission 3 } }";
    CHECK(help(lamp).find("black where none is given") != std::string::npos);
    CHECK(help("sphere { 0, 1 }").find("light_source") != std::string::npos);
    CHECK(help("sphere { 0, 1 } light_source { 9*y }").find("light_source") != std::string::npos);
}

TEST_CASE("a camera inside of what changes no picture is not spoken of", "[world]") {
    const std::string camera = "camera { location z look_at 0 } ";
    const std::string outside = "light_source { 99*y, 1 } ", within = "light_source { y, 1 } ";
    const auto said = [&](const std::string& rest) { return said_about(camera + rest, true); };
    const std::string glow = "pigment { rgb 1 } finish { emission 1 } ";
    CHECK(said(outside + "sphere { 0, 9 }") == "camera-inside ");
    CHECK(said(within + "sphere { 0, 9 }") == "");
    CHECK(said(outside + within + "sphere { 0, 9 }") == "");
    CHECK(said("light_source { y, 1 parallel point_at 0 } sphere { 0, 9 }") == "camera-inside ");
    CHECK(said("light_source { 99*y, 1 shadowless } sphere { 0, 9 }") == "");
    CHECK(said(outside + "sphere { 0, 9 no_shadow }") == "");
    CHECK(said(outside + "sphere { 0, 9 pigment { rgbt <1, 1, 1, 0.9> } }") == "");
    CHECK(said("sphere { 0, 9 " + glow + "}") == "glowing-dome ");
    CHECK(said("sphere { 0, 9 } sphere { 2*y, 0.1 " + glow + "}") == "");
    CHECK(said("sphere { 0, 9 } sphere { 20*y, 0.1 " + glow + "}") == "camera-inside ");
    CHECK(said("background { rgb 1 } sphere { 0, 9 finish { ambient 1 } }") == "");
    const std::string fog = "fog { distance 10 rgb 1 } ";
    CHECK(said(fog + within + "sphere { 0, 9 }") == "camera-inside ");
    CHECK(said(fog + within + "sphere { 0, 9 hollow }") == "");
}

TEST_CASE("light below surfaces that the scene does not ask for is warned of", "[world]") {
    const std::string seen =
        "light_source { 0, 1 } camera { location -9*z } sphere { 0, 1 finish "
        "{ subsurface { translucency 1 } } } ";
    CHECK(said_about(seen, false) == "no-effect ");
    CHECK(said_about(seen + "global_settings { subsurface { } }", false).empty());
}

TEST_CASE("what path tracing passes over is warned of", "[world]") {
    const std::string seen =
        "light_source { 0, 1 } camera { location -9*z } sphere { 0, 1 finish { reflection { 0.5 "
        "exponent 2 } } } global_settings { radiosity { } } ";
    CHECK(said_about(seen, false).empty());
    CHECK(said_about(seen + "global_settings { integrator { path_traced } }", false) ==
          "no-effect no-effect ");
}

TEST_CASE("a solid around the camera that hides media is warned of", "[world]") {
    const std::string smoke =
        "light_source { 0, 1 } camera { location -5*z } plane { z, 3 $ } "
        "sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { emission 1 } } } ";
    const auto with = [&](const std::string& word) {
        std::string scene = smoke;
        return scene.replace(scene.find('$'), 1, word);
    };
    CHECK(said_about(with(""), false) == "camera-inside ");
    CHECK(said_about(with("hollow"), false).empty());
}

TEST_CASE("distances in media have no effect without media", "[world]") {
    const std::string seen =
        "light_source { 0, 1 } camera { location -9*z } sphere { 0, 1 } "
        "global_settings { light_sampler { light_bvh { exponential } } } ";
    CHECK(said_about(seen, false) == "no-effect ");
    CHECK(said_about(seen + "media { scattering { 1, 0.1 } }", false).empty());
}

TEST_CASE(
    "numbers of photons without effect are warned of, those of reflected luminaires have some",
    "[world]") {
    const std::string seen = "light_source { 0, 1 } camera { location -9*z } sphere { 0, 1 } ";
    CHECK(said_about(seen + "global_settings { photons { count 10 } }", false).empty());
    CHECK(said_about(seen + "global_settings { photons { } }", false) == "no-effect ");
    const std::string settings =
        "global_settings { integrator { path_traced reflected_luminaires 9 } } ";
    CHECK(said_about(seen + settings, false).empty());
    CHECK(said_about(seen + settings + "fog { distance 9 }", false).empty());
    CHECK(
        said_about(seen + settings +
                       "global_settings { photons { count 10 } } sphere { 4, 1 pigment { rgbt 1 } "
                       "photons { target refraction on } }",
                   false)
            .empty());
}

TEST_CASE("a picture of another shape than the camera's view is warned of", "[world]") {
    struct Case {
        const char* camera;
        int width, height;
        const char* message;  ///< its beginning; empty: none
    };
    const auto [camera, width, height, message] = GENERATE(values<Case>({
        {"location -z", 320, 240, ""},
        {"location -z", 1920, 1080, "the picture is 16:9 and the camera's view 4:3"},
        {"location -z", 100, 100, "the picture is 1:1 and the camera's view 4:3"},
        {"location -z right x*16/9", 1920, 1080, ""},
        {"location -z right x*16/9 look_at <1, 2, 3> angle 50", 1366, 768, ""},
        {"location -z right x*16/9", 640, 480, "the picture is 4:3 and the camera's view 16:9"},
        {"location -z right -16*x up 9*y", 160, 90, ""},
        {"location -z right x up 2*y", 90, 160, "the picture is 9:16 and the camera's view 1:2"},
        {"location -z right x*239/100", 100, 100,
         "the picture is 1:1 and the camera's view 2.39:1"},
        {"location -z right x*777/130", 777, 130, ""},
        {"location -z scale <1, 2, 1>", 320, 240, "the picture is 4:3 and the camera's view 2:3"},
        {"orthographic location -z", 160, 90, "the picture is 16:9"},
        {"fisheye location -z right x up y", 160, 90, "the picture is 16:9"},
        {"panoramic location -z", 160, 90, ""},
        {"location -z", 31, 10, ""},
        {"location -z", 32, 10, "the picture is 16:5"},
        {"spherical location -z", 200, 100, ""},
    }));
    CAPTURE(camera, width, height);
    Diagnostics diagnostics;
    review_shape(scene_of("camera { " + std::string(camera) + " }"), width, height, diagnostics);
    const std::string said =
        diagnostics.all().empty() ? std::string() : diagnostics.all().front().message;
    CHECK(said.starts_with(message));
    CHECK(said.empty() == std::string(message).empty());
}

TEST_CASE("the shape of a picture without a camera is not spoken of", "[world]") {
    Diagnostics diagnostics;
    review_shape(scene_of("sphere { 0, 1 }"), 100, 30, diagnostics);
    CHECK(diagnostics.all().empty());
}

}  // namespace candelabra
