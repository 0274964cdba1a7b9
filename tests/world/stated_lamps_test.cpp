// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/stated_lamps.h"

#include "photometry/light_colour.h"
#include "support/scripts.h"
#include "world/compile.h"
#include "world/radiance.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// A unit is a metre, and a radiance of 1 is a candela per square metre, so that a surface of area
/// A and flux F lumens on one side has the radiance F / (pi A).
const std::string head =
    "#version 3.7; global_settings { photometry { unit 1 white 1 } } plane { y, -9 pigment { rgb 1 "
    "} "
    "} #default { pigment { rgb 1 } } ";

SharedWorld lit(const std::string& objects) { return world_of(head + objects); }

/// Luminance of the first luminaires.
std::vector<double> luminances(const std::string& objects) {
    const SharedWorld world = lit(objects);
    std::vector<double> all;
    for (const Luminaire& each : world->lights.luminaires.own())
        all.push_back(light_luminance(each.radiance));
    return all;
}

bool near(const std::vector<double>& found, const std::vector<double>& expected) {
    if (found.size() != expected.size()) return false;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (std::abs(found[i] - expected[i]) > 1e-3 * expected[i]) return false;
    return true;
}

}  // namespace

TEST_CASE("the radiance of a lamp follows from its flux and its area", "[world]") {
    const std::string flux = " luminaire { flux lumen(100) } ";
    struct Row {
        std::string objects;
        std::vector<double> expected;
    };
    const double one = 100 / pi;
    const std::vector<Row> rows = {
        {"sphere { 0, 2" + flux + "}", {one / (16 * pi)}},
        {"sphere { 0, 2" + flux + "scale 3 }", {one / (144 * pi)}},
        {"sphere { 0, 2 finish {" + flux + "} scale 3 }", {one / (144 * pi)}},
        // A disc shines on both sides.
        {"disc { 0, y, 1" + flux + "}", {one / (2 * pi)}},
        {"box { 0, 1" + flux + "scale <1, 2, 3> }", {one / 22}},
        // In a finish each shape has the flux, in an object all of it together.
        {"union { sphere { 0, 1 } sphere { 5, 2 } finish {" + flux + "} }",
         {one / (4 * pi), one / (16 * pi)}},
        {"union { sphere { 0, 1 } sphere { 5, 2 }" + flux + "}",
         {one / (20 * pi), one / (20 * pi)}},
        // What has an emission of its own in the object glows, the rest does not.
        {"union { sphere { 0, 1 finish { emission 3 } } sphere { 5, 2 }" + flux + "}",
         {one / (4 * pi)}},
        {"union { sphere { 0, 1 finish { emission 3 } } sphere { 5, 2 finish { emission 1 } }" +
             flux + "}",
         {3 * one / (28 * pi), one / (28 * pi)}},
        {"#declare L = sphere { 0, 1" + flux + "} object { L } object { L scale 2 translate 9*x }",
         {one / (4 * pi), one / (16 * pi)}},
        {"#declare T = torus { 2, 0.5 finish {" + flux +
             "} } object { T } object { T scale 2 rotate 20 translate 9*x }",
         {one / (4 * pi * pi), one / (16 * pi * pi)}},
        // The inside of a closed mesh is not seen.
        {"mesh2 { vertex_vectors { 4, 0, x, y, z } face_indices { 4, <0, 1, 2>, <0, 2, 3>, <0, 3, "
         "1>, <3, 2, 1> }" +
             flux + "}",
         std::vector<double>(4, one / (1.5 + std::sqrt(3) / 2))},
        {"mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> }" + flux + "}",
         {one / (2 * 0.5)}},
        {"difference { sphere { 0, 1 } box { <-2, 0, -2>, 2 }" + flux + "}",
         {one / (3 * pi), one / (3 * pi)}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.objects);
        const std::vector<double> found = luminances(row.objects);
        CAPTURE(found, row.expected);
        CHECK(near(found, row.expected));
    }
}

TEST_CASE("a pattern counts by its mean luminance", "[world]") {
    const SharedWorld world =
        lit("sphere { 0, 1 pigment { gradient y color_map { [0.5 rgb 0.5] [0.5 rgb 1] } scale 2 "
            "translate -y } luminaire { flux lumen(100) } }");
    REQUIRE(world->lights.luminaires.size() == 1);
    // One half has twice the radiance of the other.
    CHECK(light_luminance(world->lights.luminaires.own()[0].radiance) ==
          Approx(100 / pi / (4 * pi) / 0.75).epsilon(1e-3));
}

TEST_CASE("a temperature gives the light its colour and does not change the flux", "[world]") {
    const SharedWorld world =
        lit("sphere { 0, 1 luminaire { flux lumen(100) temperature 2700 } }"
            "sphere { 5, 1 finish { luminaire { flux lumen(100) temperature 2700 } } }");
    REQUIRE(world->lights.luminaires.size() == 2);
    for (const Luminaire& each : world->lights.luminaires.own()) {
        CHECK(light_luminance(each.radiance) == Approx(100 / pi / (4 * pi)).epsilon(1e-6));
        CHECK(each.radiance.r / each.radiance.b == Approx(1.9351 / 0.191796).epsilon(1e-3));
    }
}

TEST_CASE("lamps of the same size share what they emit", "[world]") {
    const SharedWorld world =
        lit("#for (I, 0, 99) sphere { 3*I*x, 1 finish { luminaire { flux lumen(100) } } } #end");
    CHECK(world->lights.luminaires.size() == 100);
    CHECK(world->appearance.outputs.size() == 2);
}

TEST_CASE("a lamp with a flux that does not glow is reported", "[world]") {
    Diagnostics diagnostics;
    compile(scene_of(head + "sphere { 0, 1 pigment { rgb 0 } luminaire { flux lumen(100) } }"), {},
            diagnostics);
    // Black emits nothing, so that there is no primitive that could glow.
    CHECK(diagnostics.all().size() <= 1);
}

TEST_CASE("a lamp with a web has the file's intensity in each direction, and its flux", "[world]") {
    const std::string file = "\"tests/photometry/files/c-quadrant-1995.ies\"";
    for (const char* const shape :
         {"sphere { 0, 0.1", "box { -0.1, <0.2, 0.1, 0.1>", "cylinder { 0, y, 0.1"}) {
        CAPTURE(shape);
        const SharedWorld world =
            lit(std::string(shape) + " luminaire { ies " + file + " } rotate 90*y }");
        REQUIRE(world->lights.luminaires.size() == 1);
        const Luminaire& lamp = world->lights.luminaires.own()[0];
        REQUIRE(lamp.web);
        const AimedWeb& web = lamp.web->web();
        double flux = 0;
        constexpr int count = 5000;
        for (int i = 0; i < count; ++i) {
            const double y = 1 - (2 * i + 1.0) / count, angle = 2.399963 * i,
                         across = std::sqrt(1 - y * y);
            const Vec3 direction(across * std::cos(angle), y, across * std::sin(angle));
            flux += 4 * pi / count * web.intensity(direction);
            const Rgb radiance = radiance_of(*world, lamp, {{}, direction});
            CHECK(max_component(radiance) <= max_component(lamp.radiance) * (1 + 1e-9));
        }
        CHECK(flux == Approx(2825.85).epsilon(0.01));
    }
    // A ball shows the area of its disc.
    const SharedWorld world = lit("sphere { 0, 0.1 luminaire { ies " + file + " } }");
    const Luminaire& lamp = world->lights.luminaires.own()[0];
    const Vec3 down(0, -1, 0);
    const Rgb radiance = radiance_of(*world, lamp, {{}, down});
    CHECK(light_luminance(radiance) * pi * 0.01 ==
          Approx(lamp.web->web().intensity(down)).epsilon(0.01));
}

TEST_CASE("a vertical lamp is dimmed by the tilt of its luminaire as its file states", "[world]") {
    // The factor is 0.9 at 45 degrees, 0.92 at 90, where the table ends.
    const std::string file = "ies \"tests/photometry/files/tilt-include-1986.ies\" ";
    const auto output = [](const std::string& object) {
        return lit(object)->appearance.outputs.back().scale;
    };
    const auto source = [](const std::string& object) {
        return light_luminance(lit(object)->lights.sources.at(0).colour);
    };
    const std::string ball = "sphere { 0, 0.1 luminaire { " + file, light = "light_source { 0, 1 ";
    struct Tilted {
        std::string aim, turn;
        double factor;
    };
    for (const Tilted& row : std::vector<Tilted>{{"", "", 1},
                                                 {"", "rotate 45*z", 0.9},
                                                 {"aim <1, -1, 0>", "", 0.9},
                                                 {"aim x c0 y", "", 0.92},
                                                 {"aim x c0 y", "rotate 90*x", 0.92},
                                                 {"aim <0, 1, 1>", "", 0.9},
                                                 {"", "rotate 180*x", 1}}) {
        CAPTURE(row.aim, row.turn);
        CHECK(output(ball + row.aim + " } " + row.turn + " }") / output(ball + "} }") ==
              Approx(row.factor));
        CHECK(source(light + file + row.aim + " " + row.turn + " }") / source(light + file + "}") ==
              Approx(row.factor));
        // A stated flux or intensity is that of the lamp in its place.
        CHECK(output(ball + row.aim + " flux lumen(800) } " + row.turn + " }") ==
              Approx(output(ball + "flux lumen(800) } }")));
        CHECK(source(light + file + row.aim + " intensity candela(100) " + row.turn + " }") ==
              Approx(source(light + file + "intensity candela(100) }")));
    }
}

}  // namespace candelabra
