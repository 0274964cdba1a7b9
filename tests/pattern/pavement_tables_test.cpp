// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/pavement_tables.h"

#include "pattern/pavement.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

namespace candelabra {

TEST_CASE("each pavement has a table of whole rows", "[pattern]") {
    for (const int sides : {3, 4, 6}) {
        const std::span<const int> patterns = pavement_patterns(sides);
        const auto tables = border_tables(sides);
        CHECK(static_cast<int>(tables.size()) ==
              std::accumulate(patterns.begin(), patterns.end(), 0));
        for (const BorderTable& table : tables) {
            INFO(sides << " sides: " << table.borders);
            CHECK(table.rows() * table.width == static_cast<int>(table.borders.size()));
            CHECK(table.rows() > 0);
            CHECK((table.shift >= 0 && table.shift < table.width));
            CHECK(std::ranges::all_of(table.borders, [&](char digit) {
                return digit >= '0' && digit <= (sides == 4 ? '3' : '7');
            }));
        }
    }
    CHECK(border_tables(5).empty());
}

TEST_CASE("tiles of pavements have the perimeters of their polygons", "[pattern]") {
    // A domino of squares has six sides, half of which count for it, on two vertices.
    const auto borders = [](const BorderTable& table) {
        int count = 0;
        for (const char digit : table.borders)
            for (int edge = 0; edge < 3; ++edge) count += (digit - '0') >> edge & 1;
        return double(count) / double(table.borders.size());
    };
    CHECK(borders(border_tables(4)[0]) == 2);
    CHECK(borders(border_tables(4)[1]) == 1.5);
    CHECK(borders(border_tables(3)[0]) == 3);
    CHECK(borders(border_tables(3)[1]) == 2);
    CHECK(borders(border_tables(6)[0]) == 1);
}

}  // namespace candelabra
