// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_density.h"

#include "support/rgb.h"

#include <catch2/catch.hpp>

#include <numeric>

namespace candelabra {

namespace {

LampList lamps_along() {
    std::vector<std::uint32_t> numbers(100);
    std::iota(numbers.begin(), numbers.end(), 0U);
    std::vector<float> powers(100, 1.0F);
    powers[1] = 3;
    return LampList({{"Row", 100}}, numbers, powers);
}

}  // namespace

TEST_CASE("light along the list is shared by powers and divided where it changes", "[relight]") {
    const LampList lamps = lamps_along();
    const std::vector<double> before = powers_before(lamps);
    CHECK(before.back() == 102);
    LampDensity density(before);
    density.add({0, 2}, Rgb(8));
    density.add({0, 50}, Rgb(52));
    density.add({70, 71}, Rgb(5));
    density.add({70, 71}, Rgb(1));
    density.settle();
    CHECK(density.light({0, 100}) == Rgb(66));
    CHECK(density.light({0, 1}) == Rgb(3));
    CHECK(density.light({1, 2}) == Rgb(9));
    CHECK(density.light({2, 50}) == Rgb(48));
    CHECK(density.light({50, 70}) == Rgb(0));
    CHECK(density.light({70, 71}) == Rgb(6));
    CHECK(density.is_even({2, 50}));
    CHECK(density.is_even({0, 2}));
    CHECK_FALSE(density.is_even({1, 3}));
    CHECK_FALSE(density.is_even({60, 80}));
    CHECK(density.is_even({71, 100}));
    for (const std::size_t most : {1U, 3U, 64U}) {
        const std::vector<LampRange> ranges = divided(density, lamps, most);
        CHECK(ranges.size() <= most);
        Rgb sum(0);
        std::uint32_t at = 0;
        for (const LampRange& range : ranges) {
            CHECK(range.first >= at);
            at = range.last;
            sum += density.light(range);
        }
        CHECK(length(sum - Rgb(66)) < 1e-9);
    }
    LampDensity none(before);
    none.settle();
    CHECK(divided(none, lamps, 10).empty());
}

}  // namespace candelabra
