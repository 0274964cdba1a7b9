// SPDX-License-Identifier: GPL-3.0-or-later
// The light of lamps with photometric webs on surfaces: as the inverse square law says, and the same
// whether lamps are sampled or found by chance.
#include "photometry/light_colour.h"
#include "render/render.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

const std::string files = CANDELABRA_SOURCE_DIR "/tests/photometry/files/";

/// Mean luminance of a picture of a few square centimetres of a white floor around the origin.
double shown(const std::string& script, int samples) {
    const Shot shot = shot_of(
        "#version 3.7; global_settings { photometry { unit 1 white 1 } integrator { path_traced } "
        "} "
        "#default { finish { ambient 0 diffuse 1 } } camera { orthographic location <0, 0.05, 0> "
        "direction -y right 0.04*x up 0.04*z } plane { y, 0 pigment { rgb 1 } } " +
        script);
    RenderSettings settings;
    settings.width = settings.height = 4;
    settings.samples = samples;
    double sum = 0;
    const auto pixels = render(shot, settings).image.pixels;
    for (const Rgb& pixel : pixels) sum += light_luminance(pixel);
    return sum / static_cast<double>(pixels.size());
}

/// Illuminance in lux of a white floor, which shows it over pi.
double lux(const std::string& script, int samples = 16) { return pi * shown(script, samples); }

}  // namespace

TEST_CASE("lamps with a file light a floor by the inverse square law", "[statistics]") {
    // Straight down, 30 degrees off, and on the other side of a file without symmetry.
    struct Row {
        const char* file;
        Vec3 place;
    };
    for (const Row& row :
         {Row{"c-axial-2002.ies", {0, 3, 0}}, Row{"c-axial-2002.ies", {1.5, 3, 0}},
          Row{"c-full-absolute-2019.ies", {1, 2, 0.5}}, Row{"c-full-absolute-2019.ies", {-1, 2, 1}},
          Row{"isym3.ldt", {0.3, 2, -1}}, Row{"b-flood-1995.ies", {0.2, 4, 0.4}}}) {
        CAPTURE(row.file, row.place.x, row.place.z);
        const std::string kind = std::string_view(row.file).ends_with("ies") ? "ies" : "ldt";
        const std::string web = kind + " \"" + files + row.file + "\"";
        const std::string at = "<" + std::to_string(row.place.x) + ", " +
                               std::to_string(row.place.y) + ", " + std::to_string(row.place.z) +
                               ">";
        const Scene scene = scene_of(
            "#version 3.7; global_settings { photometry { unit 1 white 1 } "
            "} light_source { 0, 1 " +
            web + " }");
        const AimedWeb aimed(scene.lights.at(0).light);
        const double distance = length(row.place);
        const double expected = aimed.intensity(-row.place) * row.place.y / std::pow(distance, 3);
        CHECK(lux("light_source { " + at + ", rgb kelvin(3000) " + web + " }") ==
              Approx(expected).epsilon(2e-3));
        for (const char* shape : {"sphere { 0, 0.02", "box { <-0.02, -0.01, -0.03>, 0.02",
                                  "torus { 0.02, 0.008", "disc { 0, y, 0.03"}) {
            CAPTURE(shape);
            const bool flat = std::string_view(shape).starts_with("disc");
            const bool concave = std::string_view(shape).starts_with("torus");
            const double found = lux(std::string(shape) +
                                         " pigment { rgb <1, 0.8, 0.6> } "
                                         "finish { diffuse 0 } luminaire { " +
                                         web + " } translate " + at + " }",
                                     concave ? 1024 : 128);
            CAPTURE(found / expected);
            // Parts of a ring hide each other, and no lamp reflects the light of its own.
            if (concave)
                CHECK((found < 1.02 * expected && found > 0.5 * expected));
            else
                CHECK(found == Approx(expected).epsilon(flat ? 0.02 : 0.03));
        }
    }
}

TEST_CASE("a lamp of so many lumens lights as its formula says", "[statistics]") {
    // A ball of 1000 lm has 1000 / (4 pi) cd; a disc that shines on both sides 500 / pi.
    CHECK(lux("sphere { 2*y, 0.1 pigment { rgb <1, 0.5, 0.2> } luminaire { flux lumen(1000) } }",
              64) == Approx(1000 / (4 * pi) / 4).epsilon(0.01));
    CHECK(lux("disc { 2*y, y, 0.02 pigment { rgb 1 } luminaire { flux lumen(1000) } }", 64) ==
          Approx(500 / pi / 4).epsilon(0.01));
    CHECK(lux("light_source { 2*y, rgb <1, 0.1, 0.1> intensity candela(1000) }") ==
          Approx(250).epsilon(1e-3));
    CHECK(lux("light_source { 1000*y, rgb lux(500) }") == Approx(500).epsilon(1e-3));
}

TEST_CASE("what a lamp with a web lights is the same sampled and found by chance", "[statistics]") {
    const std::string web = "ies \"" + files + "c-quadrant-1995.ies\"";
    for (const char* shape :
         {"sphere { 0, 0.8", "box { -0.7, 0.7", "superellipsoid { <0.5, 0.5> scale 0.8",
          "cylinder { -0.6*x, 0.6*x, 0.5"}) {
        CAPTURE(shape);
        const auto lit = [&](const std::string& finish, int samples) {
            return lux(std::string(shape) +
                           " pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0 "
                           "luminaire { " +
                           web + " flux lumen(1000) } " + finish +
                           " } rotate <20, 30, 10> translate <0.4, 1.6, 0.2> }",
                       samples);
        };
        CHECK(lit("", 400) == Approx(lit("no_luminaire", 20000)).epsilon(0.02));
    }
}

}  // namespace candelabra
