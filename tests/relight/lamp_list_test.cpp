// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_list.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("lamps have places by group and number", "[relight]") {
    const LampList lamps({{"Key", 1}, {"None", 0}, {"Row", 3}}, {0, 2, 0, 1}, {1, 1, 1, 1});
    CHECK(lamps.size() == 4);
    CHECK(lamps.range_of(0) == LampRange{0, 1});
    CHECK(lamps.range_of(1) == LampRange{1, 1});
    CHECK(lamps.range_of(2) == LampRange{1, 4});
    CHECK(lamps.place_of(0, 0) == 0);
    CHECK(lamps.place_of(2, 0) == 2);
    CHECK(lamps.place_of(2, 1) == 3);
    CHECK(lamps.place_of(2, 2) == 1);
}

TEST_CASE("nodes of lamps are divided between groups, and groups in the middle", "[relight]") {
    std::vector<std::uint32_t> numbers = {0, 0, 1, 2, 3, 4, 5, 0, 1};
    const LampList lamps({{"A", 1}, {"B", 6}, {"C", 2}}, numbers, std::vector<float>(9, 1.0F));
    CHECK(lamps.division_of({0, 9}) == 7);
    CHECK(lamps.division_of({0, 7}) == 1);
    CHECK(lamps.division_of({1, 7}) == 4);
    CHECK(lamps.division_of({7, 9}) == 8);
    CHECK(lamps.division_of({2, 4}) == 3);
}

TEST_CASE("numbers of a group are 0, 1, ... in any order", "[relight]") {
    const std::vector<LampGroup> groups = {{"A", 1}, {"B", 2}};
    CHECK(are_numbers_of(groups, {0, 1, 0}));
    CHECK_FALSE(are_numbers_of(groups, {0, 1, 1}));
    CHECK_FALSE(are_numbers_of(groups, {0, 2, 0}));
    CHECK_FALSE(are_numbers_of(groups, {0, 1}));
    CHECK_FALSE(are_numbers_of(groups, {0, 0, 1, 0}));
}

}  // namespace candelabra
