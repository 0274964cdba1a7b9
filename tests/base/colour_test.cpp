// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/colour.h"

#include <catch2/catch.hpp>

#include <vector>

namespace candelabra {

TEST_CASE("sRGB codes of linear values", "[base]") {
    const std::vector<std::pair<double, double>> table = {
        {0, 0}, {0.002, 0.02584},   {0.2140411405, 0.5}, {0.0508760844, 0.25},
        {1, 1}, {-0.001, -0.01292},
    };
    for (const auto& [linear, encoded] : table) {
        CHECK(srgb_encode(linear) == Approx(encoded).margin(1e-9));
        CHECK(srgb_decode(encoded) == Approx(linear).margin(1e-9));
    }
    for (double linear = -0.5; linear < 5; linear += 0.0625)
        CHECK(srgb_decode(srgb_encode(linear)) == Approx(linear).margin(1e-12));
}

TEST_CASE("what passes through a colour", "[base]") {
    const Colour glass{Rgb(1, 0.5, 0), 0.5, 0.25};
    CHECK(glass.passing() == Rgb(0.75, 0.5, 0.25));
    CHECK(glass.opacity() == 0.25);
    CHECK(Colour{Rgb(1)}.passing() == Rgb(0));
    CHECK(Colour{Rgb(1)}.opacity() == 1);
    CHECK(grey(Rgb(1, 0.5, 0)) == Approx(0.5915));
    CHECK(grey(Rgb(1)) == Approx(1));
}

}  // namespace candelabra
