// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/random.h"

#include <catch2/catch.hpp>

#include <array>
#include <set>
#include <vector>

namespace candelabra {

TEST_CASE("the mixer is the finaliser of SplitMix64", "[base]") {
    // The first values of the generator with seed 0: its state grows by a constant each time.
    CHECK(mix(0) == 0xe220a8397b1dcdafu);
    CHECK(mix(0x9e3779b97f4a7c15u) == 0x6e789e6aa1b965f4u);
    CHECK(mix(2 * 0x9e3779b97f4a7c15u) == 0x06c45d188009454fu);
}

TEST_CASE("every part of a key and the purpose change the number", "[base]") {
    const std::vector<Key> keys = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0},
                                   {0, 0, 1, 0}, {0, 0, 0, 1}, {std::uint64_t{1} << 40, 0, 0, 0}};
    std::set<double> seen;
    for (const Key& key : keys)
        for (const Purpose purpose :
             {Purpose::pixel_x, Purpose::pixel_y, Purpose::light_choice, Purpose::light_u})
            CHECK(seen.insert(uniform(key, purpose)).second);
    CHECK(uniform(keys[1], Purpose::pixel_x) == uniform(keys[1], Purpose::pixel_x));
    CHECK(uniform(keys[0].with_branch(1), Purpose::pixel_x) == uniform(keys[4], Purpose::pixel_x));
}

TEST_CASE("bounces of different kinds and depths have different keys", "[base]") {
    std::set<double> seen;
    std::vector<Key> level = {Key{7, 3, 0, 2}};
    for (int depth = 0; depth < 4; ++depth) {
        std::vector<Key> next;
        for (const Key& key : level) {
            CHECK(seen.insert(uniform(key, Purpose::light_u)).second);
            next.push_back(key.branched(Branch::reflection));
            next.push_back(key.branched(Branch::refraction));
        }
        level = next;
    }
    CHECK(level.front().branch == 0);
}

TEST_CASE("numbers are uniform, also in pairs", "[base]") {
    constexpr int side = 16, count = 64000;
    std::array<int, side * side> met{};
    for (std::uint32_t i = 0; i < count; ++i) {
        const Key key{i, 7, 0, 0};
        const double x = uniform(key, Purpose::light_u), y = uniform(key, Purpose::light_v);
        REQUIRE((x >= 0 && x < 1 && y >= 0 && y < 1));
        ++met[static_cast<std::size_t>(x * side) * side + static_cast<std::size_t>(y * side)];
    }
    double chi2 = 0;
    for (const int n : met) chi2 += (n - 250.0) * (n - 250.0) / 250.0;
    // 255 degrees of freedom: mean 255, standard deviation 22.6.
    CHECK(chi2 > 170);
    CHECK(chi2 < 340);
}

TEST_CASE("the samples of a pixel are spread evenly", "[base]") {
    // Owen-scrambled Sobol points: of 2^n points, one lies in each part of every division of the
    // square into 2^n equal rectangles, and one in each part of the line.
    for (std::uint64_t pixel = 0; pixel < 20; ++pixel)
        for (int wide = 0; wide <= 8; ++wide) {
            std::set<int> cells, places, parts;
            for (std::uint32_t i = 256; i < 512; ++i) {
                const Key key{pixel, i, 3, 1};
                const auto note = [&](std::set<int>& met, Purpose across, Purpose along) {
                    const int x = static_cast<int>(uniform(key, across) * (1 << wide));
                    const int y = static_cast<int>(uniform(key, along) * (256 >> wide));
                    met.insert(x * 256 + y);
                };
                note(cells, Purpose::light_u, Purpose::light_v);
                note(places, Purpose::lens_u, Purpose::lens_v);
                parts.insert(static_cast<int>(256 * uniform(key, Purpose::light_choice)));
            }
            CHECK(cells.size() == 256);
            CHECK(places.size() == 256);
            CHECK(parts.size() == 256);
        }
}

TEST_CASE("choice and place of a sample are independent", "[base]") {
    double product = 0;
    constexpr int count = 40000;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Key key{i / 100, i % 100, 0, 0};
        product +=
            (uniform(key, Purpose::light_choice) - 0.5) * (uniform(key, Purpose::light_u) - 0.5);
    }
    CHECK(std::abs(product / count) < 5 / (12 * std::sqrt(count)));
}

}  // namespace candelabra
