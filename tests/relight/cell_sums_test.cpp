// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/cell_sums.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a blur spreads the numbers of a cell along rows and columns", "[relight]") {
    CellSums cells(7, 5, 2);
    cells.at(3, 2)[0] = 1;
    cells.at(3, 2)[1] = -2;
    blur(cells, 1, 2);
    const std::vector<double> weights = {1, 2, 3, 2, 1};
    for (std::size_t y = 0; y < 5; ++y)
        for (std::size_t x = 0; x < 7; ++x) {
            const double right = x >= 1 && x <= 5 ? weights[x - 1] * weights[y] : 0;
            CHECK(cells.at(x, y)[0] == Approx(right));
            CHECK(cells.at(x, y)[1] == Approx(-2 * right));
        }
    CellSums same(4, 3, 1);
    for (double& value : same.values) value = 2;
    const std::vector<double> before = same.values;
    blur(same, 0, 1);
    CHECK(same.values == before);
}

TEST_CASE("a radius between two blurs as between them", "[relight]") {
    // Once along a row: 1, 1 and a half, twice.
    CellSums cells(9, 1, 1);
    cells.at(4, 0)[0] = 1;
    blur(cells, 0.5, 1);
    const std::vector<double> weights = {0, 0, 0.25, 1, 1.5, 1, 0.25, 0, 0};
    for (std::size_t x = 0; x < 9; ++x) CHECK(cells.at(x, 0)[0] == Approx(weights[x]));
}

TEST_CASE("a blur may be wider than the picture", "[relight]") {
    CellSums cells(2, 2, 1);
    cells.values = {1, 2, 3, 4};
    blur(cells, 100.5, 1);
    for (const double value : cells.values) CHECK(value == Approx(10 * 4));
}

}  // namespace candelabra
