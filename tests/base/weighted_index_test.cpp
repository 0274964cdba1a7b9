// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/weighted_index.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("each place belongs to one element, and each with a weight has places", "[base]") {
    Draw draw(1);
    for (const std::size_t count : {1u, 2u, 10u, 5000u, 100000u}) {
        std::vector<double> given = draw.weights(count);
        given[0] = 1;
        const WeightedIndex places(given);
        CHECK(places.size() == count);
        for (int i = 0; i < 2000; ++i) {
            const auto element =
                static_cast<std::uint32_t>(draw.number() * static_cast<double>(count));
            CHECK((places.of(element) > 0) == (given[element] > 0));
            if (places.of(element) == 0) continue;
            CHECK(places.at(places.before(element)) == element);
            CHECK(places.at(places.end(element) - 1) == element);
        }
        CHECK(places.total() == places.end(static_cast<std::uint32_t>(count - 1)));
        CHECK(places.total() < 1ull << 53);
    }
}

TEST_CASE("places are in proportion to the weights", "[base]") {
    const WeightedIndex places(std::vector<double>{1, 2, 0, 5});
    const auto share = [&](std::uint32_t element) {
        return static_cast<double>(places.of(element)) / static_cast<double>(places.total());
    };
    CHECK(share(0) == Approx(0.125));
    CHECK(share(3) == Approx(0.625));
    CHECK(places.of(2) == 0);
    CHECK(places.at_share(0.5) == 3);
    CHECK(places.within(3, 0.5) == Approx(0.2));
    CHECK(places.within(3, 0.3) == 0);
    CHECK(places.within(0, 0.2) < 1);
    CHECK(WeightedIndex(std::vector<double>{0, 0}).total() == 0);
    CHECK(WeightedIndex(std::vector<double>{1e-300, 1e200}).of(0) == 1);
}

}  // namespace candelabra
