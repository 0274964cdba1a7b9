// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/sample_turns.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace candelabra {

TEST_CASE("samples see all items once in each turn", "[camera]") {
    for (std::uint32_t count = 1; count <= 40; ++count)
        for (std::uint64_t pixel = 0; pixel < 5; ++pixel)
            for (std::uint32_t begin : {0U, 3U, 4'000'000'000U}) {
                std::set<std::uint32_t> seen;
                for (std::uint32_t i = 0; i < count; ++i)
                    seen.insert(item_in_turn(Turns::moments, count, {pixel, begin + i, 0, 0}));
                CAPTURE(count);
                CHECK(seen.size() == count);
                CHECK(*seen.rbegin() == count - 1);
            }
}

TEST_CASE("a few samples see items that lie apart", "[camera]") {
    for (std::uint32_t count : {8U, 12U, 16U, 30U}) {
        std::vector<std::uint32_t> seen;
        for (std::uint32_t i = 0; i < 4; ++i)
            seen.push_back(item_in_turn(Turns::moments, count, {7, i, 0, 0}));
        std::ranges::sort(seen);
        std::uint32_t widest = seen.front() + count - seen.back();
        for (std::size_t i = 1; i < seen.size(); ++i)
            widest = std::max(widest, seen[i] - seen[i - 1]);
        CAPTURE(count);
        CHECK(widest <= count / 2);
    }
}

TEST_CASE("pixels begin with each item equally often, one kind apart from the other", "[camera]") {
    constexpr int count = 6, pixels = 36'000;
    std::vector<int> pairs(count * count);
    for (std::uint64_t pixel = 0; pixel < pixels; ++pixel) {
        const Key key{mix(1) + pixel, 2, 0, 0};
        ++pairs[item_in_turn(Turns::moments, count, key) * count +
                item_in_turn(Turns::camera_rays, count, key)];
    }
    const double mean = static_cast<double>(pixels) / (count * count);
    for (const int each : pairs) CHECK(std::abs(each - mean) < 5 * std::sqrt(mean));
}

}  // namespace candelabra
