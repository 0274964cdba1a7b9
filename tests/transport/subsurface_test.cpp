// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/subsurface.h"

#include "support/scripts.h"
#include "transport/integrator.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Returns the light of a solid under white light from the viewer's side, seen straight on. `solid`
/// has no closing brace yet.
Rgb seen(const std::string& solid, const std::string& settings, const std::string& finish) {
    const Shot shot = shot_of("global_settings { " + settings + R"( }
        light_source { -1000*z rgb 1 parallel point_at 0 } )" +
                              solid + R"(
        finish { ambient 0 )" +
                              finish + " } interior { ior 1.3 } }");
    Rgb sum(0);
    constexpr std::uint32_t count = 100;
    for (std::uint32_t i = 0; i < count; ++i) {
        Key key;
        key.sample = i;
        sum += Integrator(shot, {}).radiance({Vec3(0, 0, -10), Vec3(0, 0, 1)}, key);
    }
    return sum / static_cast<double>(count);
}

const std::string box = "box { <-9, -9, 0>, <9, 9, 9> pigment { rgb <0.8, 0.5, 0.1> } ";

}  // namespace

TEST_CASE("light comes out of a half space as in POV-Ray 3.7", "[render]") {
    // Measured with POV-Ray for pigments of one grey and samples 400, 40.
    const Vec3 expected(0.8128, 0.5215, 0.1188);
    for (const char* const translucency : {"0.3", "1", "<3, 1, 0.3>"}) {
        const Rgb found =
            seen(box, "subsurface { samples 50, 50 }",
                 std::string("diffuse 1 subsurface { translucency ") + translucency + " }");
        for (int i = 0; i < 3; ++i) CHECK(found[i] == Approx(expected[i]).epsilon(0.03));
    }
}

TEST_CASE("a plane gives back twice what spreads in it, as in POV-Ray 3.7", "[render]") {
    const Rgb found = seen("plane { -z, 0 pigment { rgb 0.5 } ", "subsurface { samples 50, 50 }",
                           "diffuse 1 subsurface { translucency 1 }");
    CHECK(found.r == Approx(1.005).epsilon(0.03));
}

TEST_CASE("without the global block a finish is diffuse as always", "[render]") {
    const Rgb found = seen(box, "mm_per_unit 1", "diffuse 1 subsurface { translucency 1 }");
    CHECK(found.r == Approx(0.8));
}

TEST_CASE("light gets round the edge of a shadow the farther, the larger a millimetre is",
          "[render]") {
    const auto shaded = [&](const std::string& scale) {
        return seen("box { <-0.2, -9, -5>, <0.2, 9, -4> pigment { rgb 0 } no_image } " + box,
                    "subsurface { samples 50, 0 } mm_per_unit " + scale,
                    "diffuse 1 subsurface { translucency 1 }")
            .r;
    };
    CHECK(shaded("1") > 2 * shaded("10"));
    CHECK(shaded("10") > 2 * shaded("100"));
}

TEST_CASE("light inside is as even as POV-Ray's with as many samples", "[render]") {
    const Shot shot =
        shot_of("global_settings { subsurface { samples 100, 0 } } " +
                std::string("light_source { -1000*z rgb 1 parallel point_at 0 } ") + box +
                "finish { ambient 0 diffuse 1 subsurface { translucency 1 } } "
                "interior { ior 1.3 } }");
    double sum = 0, squares = 0;
    constexpr std::uint32_t count = 200;
    for (std::uint32_t i = 0; i < count; ++i) {
        Key key;
        key.pixel = mix(i);
        const double light = Integrator(shot, {}).radiance({Vec3(0, 0, -10), Vec3(0, 0, 1)}, key).g;
        sum += light;
        squares += light * light;
    }
    const double mean = sum / count;
    // In POV-Ray the deviation is 2.6 % of the mean.
    CHECK(std::sqrt(squares / count - mean * mean) < 0.035 * mean);
}

}  // namespace candelabra
