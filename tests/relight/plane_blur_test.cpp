// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/plane_blur.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a blur spreads a value along rows and columns", "[relight]") {
    std::vector<float> plane(7 * 5);
    plane[2 * 7 + 3] = 1;
    blur(plane, 7, 5, 1, 2);
    const std::vector<float> weights = {1, 2, 3, 2, 1};
    for (std::size_t y = 0; y < 5; ++y)
        for (std::size_t x = 0; x < 7; ++x) {
            const float right = x >= 1 && x <= 5 ? weights[x - 1] * weights[y] : 0;
            CHECK(plane[y * 7 + x] == Approx(right));
        }
    std::vector<float> same(12, 2);
    blur(same, 4, 3, 0, 1);
    CHECK(same == std::vector<float>(12, 2));
}

TEST_CASE("a blur may be wider than the picture", "[relight]") {
    std::vector<float> plane = {1, 2, 3, 4};
    blur(plane, 2, 2, 100, 1);
    for (const float value : plane) CHECK(value == Approx(10 * 4));
}

}  // namespace candelabra
