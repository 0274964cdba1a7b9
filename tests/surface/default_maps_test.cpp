// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/default_maps.h"

#include "support/rgb.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("patterns have POV-Ray's colours when none are given", "[surface]") {
    struct Case {
        Pattern pattern;
        double value;
        Rgb expected;
    };
    Mandel cubic;
    cubic.exponent = 3;
    const std::vector<Case> cases = {
        {Gradient{}, 0.25, Rgb(0.25)},
        {Agate{}, 0.5, Rgb(0.95, 0.75, 0.5)},
        {Bozo{}, 0.7, Rgb(0, 0, 1)},
        {Spotted{}, 0.7, Rgb(0.7)},
        {Brick{}, 0, Rgb(0.5)},
        {Brick{}, 1, Rgb(0.6, 0.15, 0.15)},
        {Checker{}, 0, Rgb(0, 0, 1)},
        {Checker{}, 1, Rgb(0, 1, 0)},
        {Hexagon{}, 2, Rgb(1, 0, 0)},
        {Square{}, 0, Rgb(1, 0, 0)},
        {Square{}, 3, Rgb(1, 1, 0)},
        {CubicPattern{}, 4, Rgb(0, 1, 1)},
        {Triangular{}, 5, Rgb(1, 0, 1)},
        {Marble{}, 0.95, Rgb(0)},
        {Wood{}, 0.3, Rgb(0.666, 0.312, 0.2)},
        {Wood{}, 0.7, Rgb(0.4, 0.1333, 0.066)},
        {Radial{}, 0, Rgb(0, 1, 1)},
        {Mandel{}, 0.0005, Rgb(0)},
        {Mandel{}, 1, Rgb(0, 1, 1)},
        {cubic, 0.5, Rgb(0.5)},
    };
    for (const Case& c : cases) {
        INFO(Kinds<Pattern>::infos[c.pattern.index()]->name << " at " << c.value);
        CHECK(length(look_up(default_map(c.pattern), c.value).rgb - c.expected) < 1e-6);
    }
}

}  // namespace candelabra
