// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/source_light.h"

#include "render/render.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// Returns the picture's only pixel, which shows the floor at the origin.
Vec3 floor_under(const std::string& lights) {
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
    const auto x = [](const std::string& lights) { return floor_under(lights).x; };
    CHECK(x("light_source { <0, 4, 3>, 0.5 }") == Approx(0.5 * 0.8).epsilon(1e-4));
    CHECK(x("light_source { 4*y, 0.5 fade_distance 2 fade_power 2 }") ==
          Approx(0.5 * 2 / 5).epsilon(1e-4));
    CHECK(x("light_source { 4*y, 0.5 spotlight point_at <9, 4, 0> }") == 0);
    CHECK(x("light_source { 4*y, 0.5 spotlight point_at 0 }") == Approx(0.5).epsilon(1e-4));
    const std::string shade = "box { <-1, 1, -1>, <1, 1.1, 1> no_image } ";
    CHECK(x(shade + "light_source { 4*y, 0.5 }") == 0);
    CHECK(x(shade + "light_source { 4*y, 0.5 shadowless }") == Approx(0.5).epsilon(1e-4));
}

TEST_CASE("fog weakens light that says so", "[render]") {
    const auto x = [](const std::string& words) {
        return floor_under("fog { rgb 0 distance 4 } light_source { 4*y, 0.5 " + words + " }").x;
    };
    CHECK(x("") == Approx(0.5 * std::exp(-0.75)).epsilon(1e-4));
    CHECK(x("media_attenuation on") == Approx(0.5 * std::exp(-1.75)).epsilon(1e-4));
    CHECK(x("media_attenuation shadowless") == Approx(0.5 * std::exp(-0.75)).epsilon(1e-4));
    CHECK(x("media_attenuation on media_interaction off") ==
          Approx(0.5 * std::exp(-0.75)).epsilon(1e-4));
}

}  // namespace candelabra
