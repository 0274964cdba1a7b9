// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/dim_set.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace {

std::vector<double> intensities(std::size_t count, Draw& draw) {
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(draw.number() < 0.1 ? 0 : std::pow(10, draw.between(-30, 30)));
    return result;
}

}  // namespace

TEST_CASE("each place belongs to the luminaire whose weight covers it", "[lighting]") {
    Draw draw(1);
    for (const std::size_t count : {1u, 2u, 10u, 5000u, 100000u}) {
        const LightWeights weights(intensities(count, draw));
        for (int i = 0; i < 2000; ++i) {
            const auto light = static_cast<LightIndex>(draw.number() * static_cast<double>(count));
            CHECK(weights.weight(light) > 0);
            CHECK(weights.at(weights.before(light)) == light);
            CHECK(weights.at(weights.before(light) + weights.weight(light) - 1) == light);
        }
        CHECK(weights.total() == weights.before(static_cast<LightIndex>(count - 1)) + weights.weight(static_cast<LightIndex>(count - 1)));
        CHECK(weights.total() < 1ull << 53);
    }
}

TEST_CASE("weights are in proportion to intensity, but for a share that all have", "[lighting]") {
    const LightWeights weights(std::vector<double>{1, 2, 0, 5});
    const auto share = [&](LightIndex light) { return static_cast<double>(weights.weight(light)) / static_cast<double>(weights.total()); };
    CHECK(share(2) == Approx(0.025));
    CHECK(share(0) == Approx(0.025 + 0.9 / 8));
    CHECK(share(3) == Approx(0.025 + 0.9 * 5 / 8));
    const LightWeights dark(std::vector<double>{0, 0});
    CHECK(dark.weight(0) == dark.weight(1));
}

TEST_CASE("a dim set is what a list leaves, without gaps and without the list", "[lighting]") {
    Draw draw(2);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const LightWeights weights(intensities(200, draw));
        std::vector<LightIndex> bright, dim;
        for (LightIndex light = 0; light < 200; ++light) (draw.number() < share ? bright : dim).push_back(light);
        const std::vector<std::uint64_t> places = dim_places(weights, bright);
        const DimSet set(weights, bright, places);
        std::uint64_t place = 0;
        for (const LightIndex light : dim) {
            CHECK(set.at(place) == light);
            CHECK(set.at(place + weights.weight(light) - 1) == light);
            place += weights.weight(light);
        }
        CHECK(set.total() == place);
    }
}
