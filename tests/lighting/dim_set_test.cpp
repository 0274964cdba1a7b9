// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/dim_set.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a dim set is what a list leaves, without gaps and without the list", "[lighting]") {
    Draw draw(2);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const WeightedIndex places(draw.weights(200));
        std::vector<LightIndex> bright, dim;
        for (LightIndex light = 0; light < 200; ++light)
            (draw.number() < share ? bright : dim).push_back(light);
        const std::vector<std::uint64_t> before = dim_places_before(places, bright);
        const DimSet set(places, bright, before);
        REQUIRE(set.lights() == dim.size());
        std::uint64_t place = 0;
        for (std::size_t n = 0; n < dim.size(); ++n) {
            CHECK(set.nth(n) == dim[n]);
            if (places.of(dim[n]) == 0) continue;
            CHECK(set.at(place) == dim[n]);
            CHECK(set.at(place + places.of(dim[n]) - 1) == dim[n]);
            place += places.of(dim[n]);
        }
        CHECK(set.places() == place);
    }
}

}  // namespace candelabra
