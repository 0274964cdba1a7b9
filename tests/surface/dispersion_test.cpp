// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/dispersion.h"

#include "support/rgb.h"

#include <catch2/catch.hpp>

#include <array>

namespace candelabra {

TEST_CASE("seven bands have the colours that POV-Ray gives them", "[surface]") {
    const std::array<Rgb, 7> expected = {
        Rgb(0.256, 0, 1.433), Rgb(0.021, 0, 2.565), Rgb(0, 0.767, 2.289), Rgb(0.069, 2.528, 0.686),
        Rgb(1.896, 2.651, 0), Rgb(2.917, 1.054, 0), Rgb(1.799, 0, 0)};
    for (int i = 0; i < 7; ++i)
        CHECK(length(hue({i, 7}) - expected[static_cast<std::size_t>(i)]) < 0.0012);
}

TEST_CASE("all bands together are nearly white", "[surface]") {
    for (const int count : {2, 7, 33, 100}) {
        Rgb sum(0);
        for (int i = 0; i < count; ++i) sum += hue({i, count}) / static_cast<double>(count);
        CHECK(length(sum - Rgb(0.9938, 1, 0.9962)) < 2e-4);
    }
}

TEST_CASE("violet is bent most", "[surface]") {
    CHECK(SpectralBand{0, 2}.power() == 0.25);
    CHECK(SpectralBand{1, 2}.power() == -0.25);
}

}  // namespace candelabra
