// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/trace.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace {

Vec3 seen(const std::string& script, const Vec3& from = Vec3(0),
          const Vec3& direction = Vec3(0, 0, 1)) {
    const World world = world_of(script);
    return Tracer(world, {}).radiance({from, unit(direction)}, Key());
}

}  // namespace

TEST_CASE("a ray that meets nothing sees the background", "[render]") {
    CHECK(seen("background { rgb <0.1, 0.2, 0.3> }") == Vec3(0.1, 0.2, 0.3));
}

TEST_CASE("facing mirrors show as many surfaces as the level allows", "[render]") {
    const std::string mirrors = R"(
        #declare Mirror = texture { pigment { rgb 1 } finish { ambient 1 diffuse 0 reflection 1 } }
        box { <-9, -9, 5>, <9, 9, 6> texture { Mirror } }
        box { <-9, -9, -6>, <9, 9, -5> texture { Mirror } }
        global_settings { max_trace_level )";
    for (const int level : {1, 3, 7})
        CHECK(seen(mirrors + std::to_string(level) + " }").x == Approx(level));
}

TEST_CASE("clear surfaces without refraction use up no level", "[render]") {
    const std::string panes = R"(
        #for (I, 1, 30) box { <-9, -9, I>, <9, 9, I + 0.5> pigment { rgbt 1 } } #end
        background { rgb 0.5 }
        global_settings { max_trace_level )";
    CHECK(seen(panes + "5 }").x == Approx(0.5));
    CHECK(seen(panes + "2 }").x == Approx(0.5));
    CHECK(seen(panes + "1 }").x == 0);  // but need one that is left
}

TEST_CASE("a glass sphere turns the picture upside down", "[render]") {
    const std::string ball = R"(
        sphere { <0, 0, 5>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
        plane { z, 20 pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } scale 200 translate -100*y }
                finish { ambient 1 diffuse 0 } }
        global_settings { max_trace_level 10 })";
    CHECK(seen(ball, Vec3(0, 0.3, 0)).x < 0.5);
    CHECK(seen(ball, Vec3(0, -0.3, 0)).x > 0.5);
}

TEST_CASE("a negative transparency takes away what is behind", "[render]") {
    CHECK(length(seen("plane { -z, -5 pigment { rgb 0.5 transmit -1 } finish { ambient 0.8 "
                      "diffuse 0 } } background { rgb <0.2, 0.3, 0.1> }") -
                 Vec3(0.6, 0.5, 0.7)) < 1e-12);
}

TEST_CASE("filtered light takes the pigment's colour", "[render]") {
    CHECK(length(seen("box { <-9, -9, 5>, <9, 9, 6> pigment { rgbf <1, 0.5, 0, 1> } finish { "
                      "ambient 0 diffuse 0 } }"
                      "background { rgb 1 } global_settings { adc_bailout 0 }") -
                 Vec3(1, 0.25, 0)) < 1e-12);
}
