// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/covering.h"

#include <catch2/catch.hpp>

#include <numeric>

namespace candelabra::proof {

TEST_CASE("a covering array has every pair, in few more rows than it must", "[proof]") {
    std::vector<std::vector<std::size_t>> levels;
    for (const std::size_t count : {9u, 7u, 5u, 5u, 3u, 2u, 2u}) {
        levels.emplace_back(count);
        std::iota(levels.back().begin(), levels.back().end(), std::size_t{0});
    }
    Covering covering(levels);
    Dice dice(1);
    int rows = 0;
    for (; covering.covered() < covering.pairs() && rows < 1000; ++rows)
        covering.cover(covering.next(dice));
    CHECK(covering.pairs() == 446);
    CHECK(covering.covered() == covering.pairs());
    CHECK(rows < 130);  // at least 63
}

TEST_CASE("rows of a covering array keep to the levels that are allowed", "[proof]") {
    const Covering covering({{4, 6}, {1}, {0, 9, 11}});
    Dice dice(2);
    for (int i = 0; i < 50; ++i) {
        const Row row = covering.next(dice);
        CHECK((row[0] == 4 || row[0] == 6));
        CHECK(row[1] == 1);
        CHECK((row[2] == 0 || row[2] == 9 || row[2] == 11));
    }
}

}  // namespace candelabra::proof
