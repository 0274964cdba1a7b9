// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/tile_records.h"

#include "base/random.h"
#include "relight/half.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

TileRecords some_records() {
    TileRecords tile;
    tile.nodes = {{2, 3}, {4, 900}};
    std::vector<TilePlanes> light(2);
    for (std::size_t i = 0; i < light[0].size(); ++i) {
        light[0][i] = 1e-6F * static_cast<float>(i);
        light[1][i] = 1000.0F / static_cast<float>(i + 1);
    }
    tile.own = {
        {7, 0, false, {1, 2, 3}}, {1000, 0, false, {1e-3F, 0, -5}}, {0, 63, false, {1, 1, 1}}};
    tile.residual = {{5, 9, false, {0.1F, 0.2F, 0.3F}}};
    tile.rest.emplace();
    (*tile.rest)[5] = 0.25F;
    round_to_file(tile, light);
    return tile;
}

}  // namespace

TEST_CASE("halves are the nearest numbers of 16 bits", "[relight]") {
    CHECK(from_half(to_half(1)) == 1);
    CHECK(from_half(to_half(-0.333F)) == Approx(-0.333).epsilon(1.0 / 2048));
    CHECK(from_half(to_half(1e9F)) == greatest_half);
    CHECK(to_half(std::nanf("")) == 0);
    CHECK(from_half(to_half(0x1p-24F)) == 0x1p-24F);
    CHECK(from_half(to_half(0x1.8p-25F)) == 0x1p-24F);
    CHECK(from_half(to_half(0x1p-26F)) == 0);
    for (std::uint32_t half = 0; half < 0x7C00; ++half) {
        const auto bits = static_cast<std::uint16_t>(half);
        REQUIRE(to_half(from_half(bits)) == bits);
        // Half of the way to the next one goes to the even one.
        if (half + 1 >= 0x7C00) continue;
        const float between =
            (from_half(bits) + from_half(static_cast<std::uint16_t>(half + 1))) / 2;
        REQUIRE(to_half(between) == (half & 1U ? half + 1 : half));
    }
}

TEST_CASE("a tile is read as it was written", "[relight]") {
    const TileRecords tile = some_records();
    std::string bytes;
    append_tile(bytes, tile);
    append_tile(bytes, TileRecords());
    CHECK(bytes.size() <= tile_head_bytes * 2 + 2 * node_bytes + 4 * entry_bytes + rest_bytes);
    std::string_view left = bytes;
    const auto first = take_tile(left, 1001);
    REQUIRE(first);
    CHECK(*first == tile);
    const auto second = take_tile(left, 1001);
    REQUIRE(second);
    CHECK(*second == TileRecords());
    CHECK(left.empty());
}

TEST_CASE("light is kept to less than a thousandth", "[relight]") {
    TileRecords tile;
    tile.nodes = {{0, 1}};
    std::vector<TilePlanes> light(1);
    for (std::size_t i = 0; i < light[0].size(); ++i)
        light[0][i] = std::ldexp(1.37F, -static_cast<int>(i) / 12);
    round_to_file(tile, light);
    for (std::size_t i = 0; i < light[0].size(); ++i)
        CHECK(from_half(tile.light[i]) * tile.scale == Approx(light[0][i]).epsilon(0.0003));
}

TEST_CASE("a lamp that was seen and lights the same pixel has one entry", "[relight]") {
    TileRecords tile;
    tile.own = {{1, 2, false, {1, 0, 0}}, {1, 2, true, {2, 0, 0}}};
    round_to_file(tile, {});
    CHECK(tile.own == std::vector<LampEntry>{{1, 2, false, {3, 0, 0}}});
}

TEST_CASE("bytes that are no tile are refused", "[relight]") {
    std::string bytes;
    append_tile(bytes, some_records());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        std::string_view part = std::string_view(bytes).substr(0, size);
        REQUIRE_FALSE(take_tile(part, 1001));
    }
    std::string_view whole = bytes;
    CHECK_FALSE(take_tile(whole, 900));  // a lamp that there is not
    // Altered bytes give a tile that is possible, or none.
    for (std::uint64_t i = 0; i < 3000; ++i) {
        std::string altered = bytes;
        const std::uint64_t random = mix(i + 1);
        // Most bytes are light; the others stand in front of it and behind it.
        const std::size_t at = i % 2 == 0 ? random % 16 : random % bytes.size();
        altered[at] = static_cast<char>(random >> 32);
        std::string_view left = altered;
        const auto tile = take_tile(left, 1001);
        if (!tile) continue;
        REQUIRE(tile->light.size() == tile->nodes.size() * 3 * tile_pixels);
        for (const LampRange& node : tile->nodes)
            REQUIRE((node.first < node.last && node.last <= 1001));
        for (const LampEntry& entry : tile->own) REQUIRE((entry.lamp < 1001 && entry.pixel < 64));
    }
}

}  // namespace candelabra
