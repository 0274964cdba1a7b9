// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/page_records.h"

#include "relight/byte_stream.h"
#include "relight/relighting.h"
#include "support/rgb.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// A wall lit by two halves of a hundred lamps, one of which is seen in a pixel.
LightRecords wall() {
    LightRecords records;
    records.width = 40;
    records.height = 24;
    std::vector<std::uint32_t> numbers(100);
    for (std::uint32_t i = 0; i < 100; ++i) numbers[i] = i;
    records.lamps = LampList({{"Row", 100}}, numbers, std::vector<float>(100, 1.0F));
    records.tiles.resize(15);
    for (TileRecords& tile : records.tiles) {
        std::vector<TilePlanes> light(2);
        light[0].fill(2);
        light[1].fill(1);
        tile.nodes = {{0, 50}, {50, 100}};
        TilePlanes rest;
        rest.fill(0.5);
        tile.rest = rest;
        round_to_file(tile, light);
    }
    records.tiles[7].own = {{70, 9, false, {40, 20, 10}}};
    return records;
}

}  // namespace

TEST_CASE("a page has all light, and lamps that are seen as dots", "[relight]") {
    const LightRecords records = wall();
    const PageRecords page = page_records(records, FilmSettings(), 1000, 1);
    CHECK(page.layers.size() == 2);
    CHECK(page.columns == 3);
    CHECK(page.rows == 2);
    CHECK(page.powers.size() == 400);
    const std::size_t seen = std::size_t{9} * 40 + 17;  // tile 7 begins at 16, 8
    for (std::size_t i = 0; i < page.layers[0].pixels.size(); ++i) {
        CHECK(length(page.layers[1].pixels[i] - Rgb(0.5)) < 1e-6);
        CHECK(length(page.layers[0].pixels[i] - Rgb(3)) < 0.01);
    }
    ByteReader dots(page.dots);
    REQUIRE(dots.short_number() == 1);
    CHECK(dots.short_number() == seen);
    CHECK(dots.short_number() == 2 * 70);
    const auto value = [](std::uint16_t code) { return (std::exp2(code / 2048.0) - 1) / 64; };
    for (const double light : {40.0, 20.0, 10.0})
        CHECK(value(dots.number<std::uint16_t>()) == Approx(light).epsilon(0.001));
    ByteReader cells(page.cells);
    for (int i = 0; i < 6; ++i) {
        REQUIRE(cells.short_number() == 2);
        for (const int share : {43690, 21845}) {
            CHECK(cells.short_number() == 0);
            CHECK(cells.short_number() == 50);
            for (int c = 0; c < 3; ++c) CHECK(std::abs(cells.number<std::uint16_t>() - share) <= 2);
        }
    }
    CHECK(cells.left().empty());
    CHECK(page_records(records, FilmSettings(), 0, 2).dots == std::string(1, '\0'));
}

TEST_CASE("a strong lamp has a layer", "[relight]") {
    LightRecords records = wall();
    for (TileRecords& tile : records.tiles)
        for (std::uint8_t i = 0; i < tile_pixels; i += 2)
            tile.own.push_back({99, i, false, {static_cast<float>(i), 1, 1}});
    const PageRecords page = page_records(records, FilmSettings(), 1000, 1);
    CHECK(page.strong == std::vector<std::uint32_t>{99});
    REQUIRE(page.layers.size() == 3);
    CHECK(page.layers[2].at(4, 3).r == 28);
    CHECK(page.layers[2].at(5, 3).r == 0);
    CHECK(length(page.layers[0].at(4, 3) - Rgb(3)) < 0.01);
}

TEST_CASE("glare scatters the light of dots into the crowds", "[relight]") {
    FilmSettings film;
    film.on = film.glares = true;
    film.glare.veil = 0.2;
    const PageRecords plain = page_records(wall(), FilmSettings(), 1000, 1),
                      glaring = page_records(wall(), film, 1000, 1);
    const auto red = [](const PageRecords& page) {
        double sum = 0;
        for (const Rgb& pixel : page.layers[0].pixels) sum += pixel.r;
        return sum;
    };
    const std::size_t beside = std::size_t{9} * 40 + 18;
    CHECK(glaring.layers[0].pixels[beside].r > plain.layers[0].pixels[beside].r);
    CHECK(red(glaring) < red(plain) + 8.5);
    CHECK(glaring.cells != plain.cells);
    CHECK(glaring.dots != plain.dots);
    CHECK(page_records(wall(), film, 1000, 2).cells == glaring.cells);
}

}  // namespace candelabra
