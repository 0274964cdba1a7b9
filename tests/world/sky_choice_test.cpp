// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/sky_choice.h"

#include "support/draw.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <string>

namespace candelabra {

TEST_CASE("a sky that is chosen has the luminance that rays see, and is drawn where it is bright",
          "[world]") {
    const SharedWorld world = world_of(
        "#version 3.7; global_settings { assumed_gamma 1 } sky_sphere { pigment { gradient y "
        "color_map { [0.9 rgb 0.1] [0.95 rgb <1, 2, 4>] } scale 2 translate -1 } luminaire }");
    const SkyChoice sky(*world);
    const double above = sky.luminance(Vec3(0, 1, 0)), below = sky.luminance(Vec3(0, -1, 0));
    CHECK(above > 10 * below);
    CHECK(below == Approx(0.1));
    CHECK(sky.brightest() == Approx(above).epsilon(0.01));
    Draw draw(1);
    int high = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 direction = sky.draw({draw.number(), draw.number()});
        CHECK(sky.density(direction) > 0);
        high += direction.y > 0.8;
    }
    CHECK(high > 300);
}

TEST_CASE("a sky glares if a small part of it outshines the rest", "[world]") {
    const auto glares = [](const std::string& pigment) {
        const SharedWorld world =
            world_of("#version 3.7; global_settings { assumed_gamma 1 } sky_sphere { pigment { " +
                     pigment + " } luminaire }");
        return SkyChoice(*world).glares();
    };
    CHECK_FALSE(glares("rgb 2"));
    CHECK_FALSE(glares("gradient y color_map { [0.5 rgb 0.3] [1 rgb 2] } scale 2 translate -1"));
    CHECK(glares("gradient y color_map { [0.99 rgb 0.3] [0.99 rgb 200] } scale 2 translate -1"));
}

}  // namespace candelabra
