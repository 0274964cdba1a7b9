// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/tile_light.h"

#include "base/random.h"
#include "relight/half.h"

#include <catch2/catch.hpp>

#include <numeric>

namespace candelabra {

namespace {

constexpr std::uint32_t many_lamps = 4096;

LampList lamps_in_a_row() {
    std::vector<std::uint32_t> numbers(many_lamps);
    std::iota(numbers.begin(), numbers.end(), 0U);
    return LampList({{"Row", many_lamps}}, numbers, std::vector<float>(many_lamps, 1.0F));
}

/// Light that comes by chance: a few strong lamps, many weak ones, and one that is seen.
struct RandomLight {
    TileLight tile;
    TilePixels pixels;
    std::vector<double> sums = std::vector<double>(many_lamps);  ///< red, of each lamp

    explicit RandomLight(std::uint64_t seed, int events = 20000, int passes = 1,
                         std::size_t room = 0) {
        const LampList lamps = lamps_in_a_row();
        for (int i = 0; i < events; ++i) {
            const std::uint64_t random = mix(mix(seed) + static_cast<std::uint64_t>(i));
            const std::size_t pixel = random % tile_pixels;
            const std::uint32_t lamp = i % 8 == 0 ? 77 : random >> 20 & (many_lamps - 1);
            const Rgb light = lamp == 77 ? Rgb(4, 2, 1) : Rgb(1, 0.5, 0.25);
            tile.add(lamp, pixel, light, false);
            count(lamp, pixel, light);
            if (passes > 1 && i % (events / passes) == 0) tile.settle(lamps, room, 1);
        }
        tile.add(500, 9, Rgb(50, 50, 50), true);
        count(500, 9, Rgb(50));
        pixels.weight.fill(16);
        for (Rgb& mean : pixels.mean) mean /= 16;
    }

    void count(std::uint32_t lamp, std::size_t pixel, const Rgb& light) {
        pixels.mean[pixel] += light;
        sums[lamp] += light.r;
    }
};

/// The red light of a tile in all pixels, with a factor of each lamp.
template <class Factor>
double red_sum(const TileRecords& tile, const Factor& factor) {
    double sum = 0;
    std::vector<double> means;
    for (std::size_t i = 0; i < tile.nodes.size(); ++i) {
        double mean = 0;
        for (std::uint32_t lamp = tile.nodes[i].first; lamp < tile.nodes[i].last; ++lamp)
            mean += factor(lamp) / tile.nodes[i].size();
        means.push_back(mean);
        for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel)
            sum += mean * from_half(tile.light[i * 3 * tile_pixels + pixel]) * tile.scale;
    }
    for (const LampEntry& entry : tile.own) sum += factor(entry.lamp) * entry.light[0];
    for (const LampEntry& entry : tile.residual)
        for (std::size_t i = 0; i < tile.nodes.size(); ++i)
            if (tile.nodes[i].first <= entry.lamp && entry.lamp < tile.nodes[i].last)
                sum += (factor(entry.lamp) - means[i]) * entry.light[0];
    return sum;
}

std::size_t bytes_of(const TileRecords& tile) {
    std::string bytes;
    append_tile(bytes, tile);
    return bytes.size();
}

}  // namespace

TEST_CASE("a tile with room keeps each lamp of each pixel", "[relight]") {
    RandomLight light(1, 300);
    const TileRecords tile = light.tile.finished(lamps_in_a_row(), light.pixels, 100000, 1);
    CHECK_FALSE(tile.nodes.empty());
    CHECK_FALSE(tile.rest);
    for (const std::uint32_t only : {77U, 500U, 3U}) {
        const auto factor = [&](std::uint32_t lamp) { return lamp == only ? 1.0 : 0.0; };
        CHECK(red_sum(tile, factor) == Approx(light.sums[only] / 16).epsilon(1e-3));
    }
}

TEST_CASE("a tile keeps to its room, and to its sum", "[relight]") {
    for (const std::size_t room : {1024U, 3000U, 9000U, 40000U}) {
        for (const int passes : {1, 7}) {
            INFO(room << " bytes, " << passes << " passes");
            RandomLight light(1, 20000, passes, room);
            const double sum = std::accumulate(light.sums.begin(), light.sums.end(), 0.0) / 16;
            const TileRecords tile = light.tile.finished(lamps_in_a_row(), light.pixels, room, 1);
            CHECK(bytes_of(tile) <= room + tile_head_bytes);
            CHECK(red_sum(tile, [](std::uint32_t) { return 1.0; }) == Approx(sum).epsilon(1e-3));
            CHECK_FALSE(tile.rest);
            // The lamp that is seen is by itself.
            float seen = 0;
            for (const LampEntry& entry : tile.own)
                if (entry.lamp == 500 && entry.pixel == 9) seen = entry.light[0];
            CHECK(seen >= 0.999F * 50 / 16);
        }
    }
}

TEST_CASE("factors on lamps keep the expected light", "[relight]") {
    const auto odd = [](std::uint32_t lamp) { return lamp % 2 == 1 ? 1.0 : 0.0; };
    const auto few = [](std::uint32_t lamp) { return lamp % 64 == 13 ? 1.0 : 0.0; };
    double made_odd = 0, made_few = 0, right_odd = 0, right_few = 0;
    for (std::uint64_t trial = 0; trial < 60; ++trial) {
        RandomLight light(trial, 8000, trial % 2 == 0 ? 1 : 4, 6000);
        for (std::uint32_t lamp = 0; lamp < many_lamps; ++lamp) {
            right_odd += odd(lamp) * light.sums[lamp] / 16;
            right_few += few(lamp) * light.sums[lamp] / 16;
        }
        const TileRecords tile =
            light.tile.finished(lamps_in_a_row(), light.pixels, 6000, mix(trial));
        CHECK_FALSE(tile.residual.empty());
        made_odd += red_sum(tile, odd);
        made_few += red_sum(tile, few);
    }
    CHECK(made_odd == Approx(right_odd).epsilon(0.01));
    CHECK(made_few == Approx(right_few).epsilon(0.06));
}

TEST_CASE("light without a lamp is the rest", "[relight]") {
    RandomLight light(1, 3000);
    light.pixels.mean[5] += Rgb(0.25, 0, 0);
    const TileRecords tile = light.tile.finished(lamps_in_a_row(), light.pixels, 9000, 1);
    REQUIRE(tile.rest);
    CHECK((*tile.rest)[5] == Approx(0.25));
    CHECK((*tile.rest)[6] == 0);
    CHECK(bytes_of(tile) <= 9000 + tile_head_bytes);
}

TEST_CASE("light that is no number is left out", "[relight]") {
    TileLight tile;
    tile.add(1, 1, Rgb(std::nan(""), 1, 1), false);
    tile.add(1, 1, Rgb(1e300), false);
    tile.add(1, 1, Rgb(0), false);
    TilePixels pixels;
    CHECK(tile.finished(lamps_in_a_row(), pixels, 9000, 1) == TileRecords());
}

TEST_CASE("a tile comes back from its bytes, and others are refused", "[relight]") {
    const LampList lamps = lamps_in_a_row();
    constexpr std::size_t room = 4000;
    RandomLight made(3, 3000, 2, room);
    std::string bytes;
    made.tile.append_to(bytes);
    std::string_view rest = bytes;
    auto read = TileLight::take(rest, many_lamps);
    REQUIRE(read);
    CHECK(rest.empty());
    CHECK(read->finished(lamps, made.pixels, room, 1) ==
          made.tile.finished(lamps, made.pixels, room, 1));
    for (std::size_t size = 0; size < bytes.size(); size += 11) {
        std::string_view part = std::string_view(bytes).substr(0, size);
        const auto some = TileLight::take(part, many_lamps);
        REQUIRE_FALSE(some);
    }
    rest = bytes;
    CHECK_FALSE(TileLight::take(rest, 77));
}

}  // namespace candelabra
