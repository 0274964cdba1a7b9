// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/colour_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a colour map is linear between its stops", "[surface]") {
    const ColourMap map = {
        {0.2, {Vec3(0), 0, 1}}, {0.6, {Vec3(1, 2, 4)}}, {0.6, {Vec3(8)}}, {0.8, {Vec3(0)}}};
    struct Case {
        double value;
        Vec3 rgb;
        double transmit;
    };
    const Case cases[] = {{-1, Vec3(0), 1},        {0.2, Vec3(0), 1}, {0.4, Vec3(0.5, 1, 2), 0.5},
                          {0.6, Vec3(1, 2, 4), 0}, {0.7, Vec3(4), 0}, {0.8, Vec3(0), 0},
                          {5, Vec3(0), 0}};
    for (const Case& c : cases) {
        const Colour found = look_up(map, c.value);
        INFO(c.value);
        CHECK(length(found.rgb - c.rgb) < 1e-12);
        CHECK(found.transmit == Approx(c.transmit).margin(1e-12));
    }
}

TEST_CASE("just above a value that stops share, the last of them counts", "[surface]") {
    const ColourMap map = {{0.5, {Vec3(1)}}, {0.5, {Vec3(2)}}, {1, {Vec3(2)}}};
    CHECK(look_up(map, 0.5).rgb.x == 1);
    CHECK(look_up(map, 0.5000001).rgb.x == Approx(2));
}

}  // namespace candelabra
