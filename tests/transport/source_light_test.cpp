// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/source_light.h"

#include "render/render.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// Returns the picture's only pixel, which shows the floor at the origin.
Rgb floor_under(const std::string& lights) {
    const Shot shot = shot_of(
        "#version 3.7; camera { location 3*y look_at 0 right 0.001*x up 0.001*z }"
        "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }" +
        lights);
    RenderSettings settings;
    settings.width = settings.height = 1;
    settings.samples = 1;
    return render(shot, settings).image.pixels[0];
}

}  // namespace

TEST_CASE("a source lights by its colour, cosine, fading, cone and shadow", "[render]") {
    const auto x = [](const std::string& lights) { return floor_under(lights).r; };
    CHECK(x("light_source { <0, 4, 3>, 0.5 }") == Approx(0.5 * 0.8).epsilon(1e-4));
    CHECK(x("light_source { 4*y, 0.5 fade_distance 2 fade_power 2 }") ==
          Approx(0.5 * 2 / 5).epsilon(1e-4));
    CHECK(x("light_source { 4*y, 0.5 spotlight point_at <9, 4, 0> }") == 0);
    CHECK(x("light_source { 4*y, 0.5 spotlight point_at 0 }") == Approx(0.5).epsilon(1e-4));
    const std::string shade = "box { <-1, 1, -1>, <1, 1.1, 1> no_image } ";
    CHECK(x(shade + "light_source { 4*y, 0.5 }") == 0);
    CHECK(x(shade + "light_source { 4*y, 0.5 shadowless }") == Approx(0.5).epsilon(1e-4));
}

TEST_CASE("light that walls reflect counts all lights of a grid as they weigh", "[render]") {
    // The floor lies in the shadow of a roof, and is lit by a wall, on which a beam far away casts a
    // wide penumbra. All lights of the grid come from nearly the same direction.
    const auto lit = [](const std::string& lights, const std::string& method) {
        const Shot shot =
            shot_of("#version 3.7; global_settings { " + method +
                    " }"
                    "camera { location <0, 1, 0> look_at <0, 0, 0.01> right 0.4*x up 0.3*y }"
                    "#default { finish { ambient 0 diffuse 0.9 } pigment { rgb 1 } }"
                    "plane { y, 0 } box { <-3, 0, 2>, <3, 3, 2.1> }"
                    "box { <-3, 1.5, -3>, <3, 1.6, 1> pigment { rgb 0 } }"
                    "box { <-2, 11, -8.1>, <0.3, 12, -8> pigment { rgb 0 } }" +
                    lights);
        RenderSettings settings;
        settings.width = 8;
        settings.height = 6;
        settings.samples = 400;
        const Image image = render(shot, settings).image;
        double sum = 0;
        for (const Rgb& pixel : image.pixels) sum += pixel.r;
        return sum / static_cast<double>(image.pixels.size());
    };
    for (const char* method :
         {"radiosity { recursion_limit 2 }", "integrator { path_traced { bounces 2 } }"}) {
        INFO(method);
        const double grid =
            lit("light_source { <0, 30, -30>, 1 area_light 4*x, 3*y, 3, 2 }", method);
        // Halves of three have the middle in common.
        std::string each;
        for (int i = 0; i < 3; ++i)
            for (const char* y : {"28.5", "31.5"})
                each += "light_source { <" + std::to_string(2 * i - 2) + ", " + y + ", -30>, " +
                        (i == 1 ? "0.25" : "0.125") + " }";
        const double apart = lit(each, method);
        CHECK(grid > 0.01);
        CHECK(grid == Approx(apart).epsilon(0.02));
    }
}

TEST_CASE("fog weakens light that says so", "[render]") {
    const auto x = [](const std::string& words) {
        return floor_under("fog { rgb 0 distance 4 } light_source { 4*y, 0.5 " + words + " }").r;
    };
    CHECK(x("") == Approx(0.5 * std::exp(-0.75)).epsilon(1e-4));
    CHECK(x("media_attenuation on") == Approx(0.5 * std::exp(-1.75)).epsilon(1e-4));
    CHECK(x("media_attenuation shadowless") == Approx(0.5 * std::exp(-0.75)).epsilon(1e-4));
    CHECK(x("media_attenuation on media_interaction off") ==
          Approx(0.5 * std::exp(-0.75)).epsilon(1e-4));
}

}  // namespace candelabra
