// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/colour_map.h"

#include "support/rgb.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a colour map is linear between its stops", "[surface]") {
    const ColourMap map = {
        {0.2, {Rgb(0), 0, 1}}, {0.6, {Rgb(1, 2, 4)}}, {0.6, {Rgb(8)}}, {0.8, {Rgb(0)}}};
    struct Case {
        double value;
        Rgb rgb;
        double transmit;
    };
    const Case cases[] = {{-1, Rgb(0), 1},        {0.2, Rgb(0), 1}, {0.4, Rgb(0.5, 1, 2), 0.5},
                          {0.6, Rgb(1, 2, 4), 0}, {0.7, Rgb(4), 0}, {0.8, Rgb(0), 0},
                          {5, Rgb(0), 0}};
    for (const Case& c : cases) {
        const Colour found = look_up(map, c.value);
        INFO(c.value);
        CHECK(length(found.rgb - c.rgb) < 1e-12);
        CHECK(found.transmit == Approx(c.transmit).margin(1e-12));
    }
}

TEST_CASE("just above a value that stops share, the last of them counts", "[surface]") {
    const ColourMap map = {{0.5, {Rgb(1)}}, {0.5, {Rgb(2)}}, {1, {Rgb(2)}}};
    CHECK(look_up(map, 0.5).rgb.r == 1);
    CHECK(look_up(map, 0.5000001).rgb.r == Approx(2));
}

}  // namespace candelabra
