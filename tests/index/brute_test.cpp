// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/brute.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("brute force visits every item once for every ray", "[index]") {
    const BruteForce brute(4);
    std::vector<std::uint32_t> seen;
    const bool stopped = brute.traverse({Vec3(0), Vec3(0)}, {},
                                        [&](std::span<const std::uint32_t> items, Interval&) {
                                            for (const std::uint32_t item : items)
                                                seen.push_back(item);
                                            return false;
                                        });
    CHECK_FALSE(stopped);
    CHECK(seen == std::vector<std::uint32_t>{0, 1, 2, 3});
}

TEST_CASE("brute force over nothing visits nothing", "[index]") {
    const auto stop = [](std::span<const std::uint32_t>, Interval&) { return true; };
    CHECK(BruteForce(1).traverse({Vec3(0), Vec3(0)}, {}, stop));
    CHECK_FALSE(BruteForce().traverse({Vec3(0), Vec3(0)}, {}, stop));
}

}  // namespace candelabra
