// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/short_list.h"

#include <catch2/catch.hpp>

#include <algorithm>

TEST_CASE("short lists do what vectors do, also beyond their room") {
    ShortList<int, 3> list;
    std::vector<int> same;
    std::uint32_t state = 1;
    for (int i = 0; i < 10'000; ++i) {
        state = state * 1664525u + 1013904223u;
        const std::uint32_t chance = state >> 16;
        if (list.empty() || chance % 5 < 3) {
            list.push_back(i);
            same.push_back(i);
        } else {
            const std::size_t first = chance / 8 % list.size();
            const std::size_t last = first + 1 + chance / 64 % (list.size() - first);
            list.erase(list.begin() + first, list.begin() + last);
            same.erase(same.begin() + static_cast<std::ptrdiff_t>(first),
                       same.begin() + static_cast<std::ptrdiff_t>(last));
        }
        REQUIRE(list.size() == same.size());
        REQUIRE(std::ranges::equal(list, same));
        const ShortList<int, 3> copy = list;
        REQUIRE(std::ranges::equal(copy, same));
    }
    list.clear();
    CHECK(list.empty());
    list.push_back(7);
    CHECK(list.back() == 7);
    CHECK(list[0] == 7);
}
