// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/light_balance.h"

#include "render/measure.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::e;
using std::numbers::pi;

const std::string in_metres =
    "#version 3.7; global_settings { photometry { unit 1 white 1 } } "
    "#default { finish { ambient 0 diffuse 0 } pigment { rgb 1 } } "
    "camera { location <5, 5, -9> } ";
const std::string ball = "sphere { 2*y, 0.5 finish { emission 3 } } ";
constexpr double of_ball = 3 * 4 * pi * 0.25;  ///< its luminance times its area

/// The normals of a smooth ball point outwards, or inwards where its faces are turned over.
const std::string balls =
    "#macro Ball(Smooth, Turned) #local N = 6; #local S = 0.7; "
    "#macro At(I, J) #if (I = 0 | I = N) (I = 0 ? y : -y) #else #local F = pi*mod(J, 2*N)/N; "
    "<sin(pi*I/N)*cos(F), cos(pi*I/N), sin(pi*I/N)*sin(F)> #end #end "
    "#macro Side(A, B, C) #local P = (Turned ? C : A); #local R = (Turned ? A : C); "
    "#local D = (Turned ? -1 : 1); #if (Smooth) smooth_triangle { S*P, D*P, S*B, D*B, S*R, D*R "
    "} #else triangle { S*P, S*B, S*R } #end #end "
    "#for (I, 0, N - 1) #for (J, 0, 2*N - 1) "
    "#if (I < N - 1) Side(At(I, J), At(I + 1, J), At(I + 1, J + 1)) #end "
    "#if (I > 0) Side(At(I, J), At(I + 1, J + 1), At(I, J + 1)) #end "
    "#end #end inside_vector y #end ";

/// The script with a mesh in the place of each BALL; all of its braces are closed but the last one.
std::string with_balls(std::string script, bool smooth, bool turned) {
    const std::string mesh =
        std::string("mesh { Ball(") + (smooth ? "1, " : "0, ") + (turned ? "1) " : "0) ");
    for (std::size_t at = 0; (at = script.find("BALL", at)) != std::string::npos;)
        script.replace(at, 4, mesh);
    return balls + script;
}

Shot remembered(const std::string& script) {
    CompileOptions options;
    options.remembers_objects = options.follows_lamps = true;
    Diagnostics diagnostics;
    return Shot(compile(scene_of(in_metres + script), options, diagnostics));
}

LightBalance balance(const std::string& script, BalanceSettings settings = {}) {
    return balance_of_light(remembered(script), settings);
}

struct BalanceAndMeter {
    LightBalance balance;  ///< within a thousandth
    MeterReading meter;    ///< the first one of the script
};
BalanceAndMeter balance_and_meter(const std::string& script, int samples_of_meter) {
    const Shot shot = remembered(script);
    BalanceSettings settings;
    settings.error = 0.001;
    MeasureSettings samples;
    samples.samples = samples_of_meter;
    const Scene scene = scene_of(in_metres + script);
    return {balance_of_light(shot, settings), measure(shot, scene.meters, samples).at(0)};
}

MeterValue lumens(const MeterValue& value) {
    const LightUnits units{1, 1};
    return {units.lumens(value.value), units.lumens(value.error)};
}

/// Checks the ends of all light, in per cent.
void check_ends(const LampBalance& lamps, const std::array<double, light_ends>& expected,
                double margin) {
    for (std::size_t i = 0; i < light_ends; ++i) {
        CAPTURE(i);
        CHECK(100 * lamps.ends[i].value / lamps.sent.value == Approx(expected[i]).margin(margin));
    }
}

}  // namespace

TEST_CASE("all light of luminaires ends where formulas say", "[render]") {
    const std::string floor = "plane { y, 0 finish { diffuse 0.5 } } ";
    // The ball, of radius 0.5 and 2 above a floor, takes back these fractions of the light that a
    // matt floor and a mirror reflect.
    const double back = 0.25 / (4 * 2 * 2), mirrored = 0.25 / (4 * 4 * 4) * 2;
    struct Row {
        const char* name;
        std::string scene;
        double sent;
        std::array<double, light_ends> ends;
    };
    // surfaces, air, above, above reflected, below, below reflected, unknown
    const Row rows[] = {
        {"nothing around", ball, of_ball, {0, 0, 50, 0, 50, 0, 0}},
        {"above a floor", ball + floor, of_ball, {25 + 25 * back, 0, 50, 25 - 25 * back, 0, 0, 0}},
        {"in a black box",
         ball + "box { <-3, 0, -3>, <3, 4, 3> }",
         of_ball,
         {100, 0, 0, 0, 0, 0, 0}},
        {"in a grey box",
         ball + "box { <-3, 0, -3>, <3, 4, 3> finish { diffuse 0.8 } }",
         of_ball,
         {100, 0, 0, 0, 0, 0, 0}},
        {"over a mirror",
         ball + "plane { y, 0 finish { reflection 0.6 } }",
         of_ball,
         {20 + 30 * mirrored, 0, 50, 30 - 30 * mirrored, 0, 0, 0}},
        {"in a globe of clear glass",
         ball + "sphere { 2*y, 1 pigment { rgbt 1 } interior { ior 1 } }",
         of_ball,
         {0, 0, 50, 0, 50, 0, 0}},
        {"in a globe that filters",
         ball + "sphere { 2*y, 1 hollow pigment { rgbt <1, 1, 1, 0.5> } }",
         of_ball,
         {50, 0, 25, 0, 25, 0, 0}},
        {"one side of a disc",
         "disc { 2*y, -y, 1 texture { finish { emission 2 } } interior_texture { finish { diffuse "
         "0 } } }",
         2 * pi,
         {0, 0, 0, 0, 100, 0, 0}},
        {"both sides of a disc that another one covers",
         "disc { 2*y, y, 1 finish { emission 2 } } disc { 1.99*y, y, 20 }",
         4 * pi,
         {50, 0, 50, 0, 0, 0, 0}},
        {"air that absorbs",
         "sphere { 0, 0.01 finish { emission 3 } } sphere { 0, 2 hollow } media { absorption 0.5 }",
         3 * 4 * pi * 1e-4,
         {37, 63, 0, 0, 0, 0, 0}},
        {"fog",
         "sphere { 0, 0.01 finish { emission 3 } } sphere { 0, 2 hollow } fog { distance 2 rgb 0 }",
         3 * 4 * pi * 1e-4,
         {37, 63, 0, 0, 0, 0, 0}},
        {"a box of glowing gas",
         "box { -0.5, 0.5 hollow pigment { rgbt 1 } interior { media { emission 3 } luminaire } }",
         12,
         {0, 0, 50, 0, 50, 0, 0}},
        // Fog covers each chord c of the ball as a whole, and leaves exp(-c/2) of its light.
        {"glowing gas in fog",
         "sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { emission 1 } luminaire } } "
         "sphere { 0, 1.0001 hollow } fog { distance 2 rgb 0 }",
         4 * 4 * pi / 3,
         {300 * (2 - 5 / e), 100 - 300 * (2 - 5 / e), 0, 0, 0, 0, 0}},
    };
    for (const Row& row : rows) {
        BalanceSettings settings;
        settings.error = 0.001;
        const LightBalance found = balance(row.scene, settings);
        CAPTURE(row.name);
        CHECK(found.reached);
        CHECK(found.all.sent.value == Approx(row.sent).epsilon(0.003));
        check_ends(found.all, row.ends, 0.25);
    }
}

TEST_CASE("lamps of any shape send the flux that they state", "[render]") {
    struct Row {
        const char* shape;   ///< without its last brace
        bool keeps = false;  ///< a part of the light meets the lamp itself
    };
    const Row rows[] = {
        {"sphere { 0, 0.7 scale <1, 2, 0.5>"},
        {"box { -0.5, <0.6, 0.4, 1> rotate <10, 20, 30>"},
        {"cylinder { -y, y, 0.4 scale <1, 1, 2>"},
        {"cylinder { -y, y, 0.4 open", true},
        {"cone { 0, 0.5, y, 0.2"},
        {"torus { 1, 0.3", true},
        {"disc { 0, y, 1, 0.3"},
        {"triangle { 0, x, y"},
        {"polygon { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>"},
        {"superellipsoid { <0.3, 0.5>"},
        {"lathe { linear_spline 4, <0, -1>, <0.3, -0.5>, <0.6, 0>, <0, 0.8>"},
        {"sor { 5, <0.1, -0.2>, <0.3, 0>, <0.5, 0.4>, <0.2, 0.8>, <0.1, 1>"},
        {"prism { 0, 1, 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>"},
        {"blob { threshold 0.5 sphere { 0, 1, 1 } sphere { 0.6*x, 0.8, 1 }"},
        {"quadric { <1, 2, 1>, 0, 0, -0.5"},
        {"ovus { 0.6, 0.3"},
        {"ovus { 0.3, 0.5"},
        {"sphere_sweep { linear_spline 3, 0, 0.2, x, 0.3, x + y, 0.1", true},
        {"isosurface { function { x*x + y*y + 2*z*z - 0.4 } contained_by { box { -1, 1 } }"},
        {"mesh { triangle { 0, x, y } triangle { x, y, z }", true},
        {"union { sphere { 0, 0.3 } box { 1, 1.4 }", true},
        {"intersection { sphere { 0, 0.6 } box { -0.5, 0.5 }"},
        {"difference { box { -0.5, 0.5 } sphere { 0, 0.6 }", true},
        {"difference { sphere { 0, 0.6 } box { <0, -1, -1>, 1 }"},
        {"merge { sphere { 0, 0.5 } sphere { 0.4*x, 0.5 }", true},
        {"sphere { 0, 0.7 clipped_by { plane { x, 0.2 } }", true},
        {"julia_fractal { <-0.083, 0, -0.83, -0.025> max_iteration 5 precision 300", true},
        {"bicubic_patch { type 1 flatness 0 u_steps 2 v_steps 2 <0,0,0>, <1,0,2>, <2,0,-1>, "
         "<3,0,0>, <0,1,0>, <1,1,2>, <2,1,0>, <3,1,0>, <0,2,0>, <1,2,0>, <2,2,1>, <3,2,0>, "
         "<0,3,0>, <1,3,0>, <2,3,0>, <3,3,0>",
         true},
        {"height_field { function 6, 6 { 0.5 + 0.4*sin(9*x)*cos(7*y) } smooth", true},
        {"parametric { function { cos(u)*(1 + 0.3*sin(v)) }, function { sin(u)*(1 + 0.3*sin(v)) "
         "}, function { v/3 } <0, 0>, <2*pi, 3> contained_by { box { -2, 2 } } max_gradient 5",
         true},
    };
    for (const Row& row : rows) {
        BalanceSettings settings;
        settings.error = 0.01;
        const LampBalance found =
            balance(std::string(row.shape) + " luminaire { flux lumen(1000) } }", settings).all;
        const MeterValue sent = lumens(found.sent), kept = lumens(found.of(LightEnd::surfaces));
        CAPTURE(row.shape, sent.error);
        CHECK(std::abs(sent.value - 1000) < 1 + 2 * sent.error);
        CHECK((kept.value > 1) == row.keeps);
    }
}

TEST_CASE("meshes send the flux that they state, however they are cut and wound", "[render]") {
    struct Row {
        const char* shape;   ///< with the mesh, which has no last brace, and its own last brace
        bool keeps = false;  ///< a part of the light meets the lamp itself
    };
    const Row rows[] = {
        {"BALL"},
        {"BALL scale <-1, 1, 2>"},
        {"BALL interior_texture { pigment { rgb 0 } }"},
        {"intersection { BALL } box { -1, 1 }"},
        {"intersection { BALL } box { -1, <0.1, 1, 1> }"},
        {"intersection { BALL } box { -1, <0.1, 1, 1> } scale <1, 1, -2>"},
        {"intersection { BALL } box { <-0.3, -1, -1>, <0.3, 1, 1> }"},
        {"intersection { BALL } plane { y, 0.2 }"},
        {"intersection { BALL } BALL translate 0.3*x }"},
        {"difference { BALL } sphere { 0.6*x, 0.5 }", true},
        {"difference { BALL } box { <0, 0, 0>, 1 }", true},
        {"difference { box { -0.8, 0.8 } BALL }", true},
        {"merge { BALL } sphere { 0.4*x, 0.5 }", true},
        {"BALL clipped_by { plane { x, 0.2 } }", true},
    };
    for (const Row& row : rows)
        for (const auto& [smooth, turned] :
             {std::pair{false, false}, {false, true}, {true, false}, {true, true}}) {
            const std::string shape = row.shape;
            // A texture of the inner side is outside on a mesh that is turned over.
            if (turned && shape.find("interior_texture") != std::string::npos) continue;
            BalanceSettings settings;
            settings.error = 0.01;
            const LampBalance found =
                balance(with_balls(shape + " luminaire { flux lumen(1000) } }", smooth, turned),
                        settings)
                    .all;
            const MeterValue sent = lumens(found.sent), kept = lumens(found.of(LightEnd::surfaces));
            CAPTURE(row.shape, smooth, turned, sent.error);
            CHECK(std::abs(sent.value - 1000) < 1 + 2 * sent.error);
            CHECK((kept.value > 1) == row.keeps);
        }
}

TEST_CASE("each statement of lamps and of objects has its light", "[render]") {
    const std::string script =
        "#for (I, 1, 3) sphere { <4*I, 2, 0>, 0.5 finish { emission I } } #end "
        "disc { <0, 5, 0>, y, 1 finish { emission 2 } } "
        "plane { y, 0 finish { diffuse 0.25 } } plane { y, 9 pigment { rgb 1 } }";
    const LightBalance found = balance(script);
    REQUIRE(found.lamps.size() == 2);
    CHECK(found.lamps[0].lamps == 3);
    CHECK(found.lamps[0].sent.value == Approx(6 * pi).epsilon(0.005));
    CHECK(found.lamps[1].lamps == 1);
    CHECK(found.lamps[1].sent.value == Approx(4 * pi).epsilon(0.005));
    double absorbed = 0;
    for (const ObjectBalance& each : found.objects) absorbed += each.absorbed.value;
    CHECK(absorbed == Approx(found.all.of(LightEnd::surfaces).value));
    CHECK(std::ranges::is_sorted(found.objects, std::greater{},
                                 [](const ObjectBalance& each) { return each.absorbed.value; }));
}

TEST_CASE("meters around a cut mesh receive the light that leaves it", "[render]") {
    // The faces of a box, each with a meter inside.
    const std::string meters =
        "#for (I, 0, 3) meter { corner vrotate(<-2, -2, 2>, 90*I*y) along vrotate(4*x, 90*I*y) "
        "across 4*y counts <8, 8> direction vrotate(-z, 90*I*y) } #end "
        "#for (I, -1, 1, 2) meter { corner <-2, 2*I, -2> along 4*x across 4*z counts <8, 8> "
        "direction -I*y } #end global_settings { integrator { path_traced } } ";
    for (const char* shape : {"intersection { BALL } box { -1, <0.1, 1, 1> }",
                              "difference { BALL } box { <0, 0, 0>, 1 }"})
        for (const char* chance : {"", "no_luminaire "})
            for (const bool turned : {false, true}) {
                const std::string script =
                    with_balls(meters + shape + " luminaire { flux lumen(1000) } " + chance + "}",
                               true, turned);
                const LightBalance found = balance(with_balls(
                    std::string(shape) + " luminaire { flux lumen(1000) } }", true, turned));
                const double leaves =
                    lumens(found.all.sent).value - lumens(found.all.of(LightEnd::surfaces)).value;
                MeasureSettings samples;
                samples.samples = 64;
                double received = 0, squares = 0;
                for (const MeterReading& each :
                     measure(remembered(script), scene_of(in_metres + script).meters, samples))
                    received += 16 * each.summary.mean.value,
                        squares += std::pow(16 * each.summary.mean.error, 2);
                const double error = std::sqrt(squares);
                CAPTURE(shape, chance, turned, received, leaves, error);
                CHECK(std::abs(received - leaves) < 3 + 1.5 * error);
                CHECK(error < 80);
            }
}

TEST_CASE("a floor absorbs what its meter receives", "[render]") {
    const std::string script =
        ball +
        "box { <-2, -0.1, -2>, <2, 0, 2> } box { <1, 0, -1>, <1.1, 1.5, 1> finish { diffuse "
        "0.7 } } meter { corner <-2, 0.001, -2> along 4*x across 4*z counts <40, 40> } "
        "global_settings { integrator { path_traced } }";
    const auto [found, reading] = balance_and_meter(script, 256);
    // A column of points is inside of the other box, and left out of the mean.
    CHECK(reading.left_out.size() == 20);
    const double lumens_through = 16 * (1 - 20.0 / 1600) * reading.summary.mean.value;
    CHECK(pi * found.objects.at(0).absorbed.value == Approx(lumens_through).epsilon(0.01));
}

TEST_CASE("a balance of light is the same for any number of threads", "[render]") {
    const std::string script = ball + "plane { y, 0 finish { diffuse 0.5 } }";
    BalanceSettings one, three;
    one.threads = 1;
    three.threads = 3;
    CHECK(balance(script, one).all.of(LightEnd::above_reflected).value ==
          balance(script, three).all.of(LightEnd::above_reflected).value);
}

TEST_CASE("a balance has as many paths as are asked for", "[render]") {
    const std::string lamps = ball + "sphere { 5*y, 0.1 finish { emission 3 } } plane { y, 0 } ";
    BalanceSettings settings;
    settings.error = 0.5;
    CHECK(balance(lamps, settings).paths == 16 * 1024);
    for (const auto& [samples, paths] :
         {std::pair{1, 16}, {100, 208}, {4096, 8192}, {20'000, 40'000}}) {
        settings.samples = samples;
        const LightBalance found = balance(lamps, settings);
        CHECK(found.paths == static_cast<std::uint64_t>(paths));
        CHECK(found.lamps.size() == 2);
    }
}

TEST_CASE("light sources send the flux that they state", "[render]") {
    struct Row {
        const char* scene;
        double sent;                          ///< lumens
        std::array<double, light_ends> ends;  ///< as above
        std::size_t lamps = 1;
    };
    const Row rows[] = {
        {"light_source { 2*y, 1 flux lumen(800) }", 800, {0, 0, 50, 0, 50, 0, 0}},
        {"light_source { 2*y, rgb <1, 0.5, 0.2> intensity candela(100) }",
         400 * pi,
         {0, 0, 50, 0, 50, 0, 0}},
        {"light_source { 2*y, 1 flux lumen(800) spotlight radius 10 falloff 30 tightness 5 "
         "point_at 0 } plane { y, 0 finish { diffuse 0.5 } }",
         800,
         {50, 0, 0, 50, 0, 0, 0}},
        {"light_source { 2*y, 1 intensity candela(300) spotlight radius 60 falloff 60 point_at 9*y "
         "}",
         300 * pi,
         {0, 0, 100, 0, 0, 0, 0}},
        {"light_source { 2*y, 1 flux lumen(500) area_light x, z, 5, 3 } plane { y, 0 }",
         500,
         {50, 0, 50, 0, 0, 0, 0}},
        {"light_source { 2*y, 1 flux lumen(500) looks_like { sphere { 0, 0.2 finish { diffuse 1 } "
         "} "
         "} }",
         500,
         {0, 0, 50, 0, 50, 0, 0}},
        {"light_source { 2*y, 1 flux lumen(650) ies "
         "\"tests/photometry/files/c-axial-2002.ies\" } plane { y, 0 }",
         650,
         {100, 0, 0, 0, 0, 0, 0}},
        {"light_source { 2*y, 1 flux lumen(600) projected_through { box { <-9, 2.1, -9>, <9, 2.2, "
         "9> } } }",
         297,  // the window's edges are seen at a height of 0.1 over 9
         {0, 0, 100, 0, 0, 0, 0}},
        {"light_source { 2*y, 1 flux lumen(300) } light_source { 4*y, 1 } "
         "light_source { 4*y, 1 flux lumen(90) shadowless } sphere { 9*y, 0.1 luminaire { flux "
         "lumen(700) } } sphere { 6*y, 9 }",
         1000,
         {100, 0, 0, 0, 0, 0, 0},
         2},
    };
    for (const Row& row : rows) {
        BalanceSettings settings;
        settings.error = 0.002;
        const LightBalance found = balance(row.scene, settings);
        const MeterValue sent = lumens(found.all.sent);
        CAPTURE(row.scene, sent.error);
        CHECK(std::abs(sent.value - row.sent) < 0.003 * row.sent + 1.5 * sent.error);
        check_ends(found.all, row.ends, 0.5);
        CHECK(found.all.lamps == row.lamps);
    }
}

TEST_CASE("a floor absorbs the light of sources that its meter receives", "[render]") {
    const std::string script =
        "light_source { <0.3, 2, 0>, 1 intensity candela(200) spotlight radius 20 falloff 50 "
        "point_at 0 } light_source { <-1, 2, 1>, 1 flux lumen(500) } box { <-2, -0.1, -2>, <2, 0, "
        "2> } sphere { <0.5, 1, 0>, 0.3 } meter { corner <-2, 0.001, -2> along 4*x across 4*z "
        "counts <80, 80> } ";
    const auto [found, reading] = balance_and_meter(script, 16);
    double absorbed = 0;
    for (const ObjectBalance& each : found.objects)
        absorbed = std::max(absorbed, each.absorbed.value);
    CHECK(pi * absorbed == Approx(16 * reading.summary.mean.value).epsilon(0.01));
}

TEST_CASE("a scene without lamps that have a flux has an empty balance", "[render]") {
    const LightBalance found =
        balance("light_source { 9*y, 1 } plane { y, 0 finish { diffuse 0.5 } }");
    CHECK(found.paths == 0);
    CHECK(found.all.sent.value == 0);
}

}  // namespace candelabra
