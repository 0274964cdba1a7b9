// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/light.h"

#include <catch2/catch.hpp>

TEST_CASE("a light fades as POV-Ray 3.7's", "[light]") {
    struct Case {
        double fade_distance, fade_power, distance, share;
    };
    const Case cases[] = {{0, 2, 5, 1},   {3, 0, 5, 1}, {3, 2, 3, 1},
                          {3, 2, 6, 0.4}, {3, 1, 0, 2}, {2, 4, 4, 2.0 / 17}};
    for (const Case& c : cases) {
        PointLight light;
        light.fade_distance = c.fade_distance;
        light.fade_power = c.fade_power;
        CHECK(fading(light, c.distance) == Approx(c.share));
    }
}
