// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/dim_set.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::vector<double> intensities(std::size_t count, Draw& draw) {
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(draw.number() < 0.1 ? 0 : std::pow(10, draw.between(-30, 30)));
    return result;
}

}  // namespace

TEST_CASE("each place belongs to one luminaire, and each that shines has places", "[lighting]") {
    Draw draw(1);
    for (const std::size_t count : {1u, 2u, 10u, 5000u, 100000u}) {
        std::vector<double> given = intensities(count, draw);
        given[0] = 1;
        const LightPlaces places(given);
        CHECK(places.lights() == count);
        for (int i = 0; i < 2000; ++i) {
            const auto light = static_cast<LightIndex>(draw.number() * static_cast<double>(count));
            CHECK((places.of(light) > 0) == (given[light] > 0));
            if (places.of(light) == 0) continue;
            CHECK(places.at(places.before(light)) == light);
            CHECK(places.at(places.end(light) - 1) == light);
        }
        CHECK(places.total() == places.end(static_cast<LightIndex>(count - 1)));
        CHECK(places.total() < 1ull << 53);
    }
}

TEST_CASE("places are in proportion to intensity", "[lighting]") {
    const LightPlaces places(std::vector<double>{1, 2, 0, 5});
    const auto share = [&](LightIndex light) {
        return static_cast<double>(places.of(light)) / static_cast<double>(places.total());
    };
    CHECK(share(0) == Approx(0.125));
    CHECK(share(3) == Approx(0.625));
    CHECK(places.of(2) == 0);
    CHECK(LightPlaces(std::vector<double>{0, 0}).total() == 0);
    CHECK(LightPlaces(std::vector<double>{1e-300, 1e200}).of(0) == 1);
}

TEST_CASE("a dim set is what a list leaves, without gaps and without the list", "[lighting]") {
    Draw draw(2);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const LightPlaces places(intensities(200, draw));
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
