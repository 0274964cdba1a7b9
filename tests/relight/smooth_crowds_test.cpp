// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/smooth_crowds.h"

#include "base/random.h"
#include "relight/relighting.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace candelabra {

namespace {

constexpr int columns = 41, rows = 27;

/// What a pixel is like: its light, the share of the first of two nodes in it, and its normal.
struct Look {
    double light = 1, share = 0.5;
    Vec3 normal = Vec3(0);
};

/// Two nodes of two lamps each.
LightRecords records_of(const std::function<Look(int x, int y)>& look) {
    LightRecords records;
    records.width = columns;
    records.height = rows;
    records.lamps = LampList({{"A", 2}, {"B", 2}}, {0, 1, 0, 1}, {1, 1, 1, 1});
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            for (int c = 0; c < 3; ++c)
                records.normals.push_back(
                    static_cast<std::int8_t>(std::lround(127 * look(x, y).normal[c])));
    for (int row = 0; row < records.tiles_down(); ++row)
        for (int column = 0; column < records.tiles_across(); ++column) {
            std::vector<TilePlanes> light(2, TilePlanes{});
            for (int i = 0; i < static_cast<int>(3 * tile_pixels); ++i) {
                const int x = column * light_tile + i % light_tile,
                          y = row * light_tile + i / light_tile % light_tile;
                if (x >= columns || y >= rows) continue;
                const Look own = look(x, y);
                const auto at = static_cast<std::size_t>(i);
                light[0][at] = static_cast<float>(own.light * own.share);
                light[1][at] = static_cast<float>(own.light * (1 - own.share));
            }
            TileRecords& tile = records.tiles.emplace_back();
            tile.nodes = {{0, 2}, {2, 4}};
            round_to_file(tile, light);
        }
    return records;
}

const std::vector<Rgb> first_node = {Rgb(1), Rgb(1), Rgb(0), Rgb(0)};

/// The greatest error where the first node is on alone.
double error_of(const std::function<Look(int x, int y)>& look, int radius) {
    const LightRecords records = records_of(look);
    const Image made = Relighting(records, radius, 2).picture(first_node);
    double most = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const Look own = look(x, y);
            most = std::max(most, std::abs(made.at(x, y).g - own.light * own.share) / own.light);
        }
    return most;
}

double random(int x, int y) {
    return static_cast<double>(mix(static_cast<std::uint64_t>(1000 * y + x)) >> 11) * 0x1p-53;
}

}  // namespace

TEST_CASE("light that changes evenly is fitted, whatever the texture", "[relight]") {
    const auto look = [](int x, int y) {
        return Look{0.1 + random(x, y), 0.2 + 0.01 * x + 0.005 * y, Vec3(0, 1, 0)};
    };
    for (const int radius : {1, 4, 9}) {
        INFO(radius);
        CHECK(error_of(look, radius) < 0.005);
    }
}

TEST_CASE("light that changes with the normal is fitted", "[relight]") {
    // Bricks that are turned by chance.
    const auto look = [](int x, int y) {
        const double turn = random(x / 2, y / 2) - 0.5;
        return Look{1, 0.5 + 0.4 * turn, unit(Vec3(turn, 1, 0))};
    };
    CHECK(error_of(look, 4) < 0.03);
    const auto unknown = [&](int x, int y) {
        Look own = look(x, y);
        own.normal = Vec3(0);
        return own;
    };
    CHECK(error_of(unknown, 4) > 0.1);
}

TEST_CASE("the light of a smooth crowd has less noise", "[relight]") {
    const auto noisy = [](int x, int y) {
        return Look{1, random(x, y) < 0.3 ? 1.0 : 0.0, Vec3(0, 0, 1)};
    };
    const LightRecords records = records_of(noisy);
    const auto error = [&](int radius) {
        const Image made = Relighting(records, radius, 1).picture(first_node);
        double squares = 0;
        for (const Rgb& pixel : made.pixels) squares += (pixel.r - 0.3) * (pixel.r - 0.3);
        return std::sqrt(squares / static_cast<double>(made.pixels.size()));
    };
    CHECK(error(0) > 0.4);
    CHECK(error(4) < 0.1);
    CHECK(error(8) < 0.06);
}

TEST_CASE("a smooth crowd is as rendered at the powers rendered, and in equal steps", "[relight]") {
    const auto look = [](int x, int y) {
        return Look{x == 20 ? 0 : 1 + 9 * random(x, y), random(y, x), Vec3(0, 1, 0)};
    };
    const LightRecords records = records_of(look);
    const Relighting smooth(records, 4, 1);
    const Image right = relit(records, std::vector<Rgb>(4, Rgb(1)), 1);
    for (const double factor : {1.0, 0.25}) {
        const Image made = smooth.picture(std::vector<Rgb>(4, Rgb(factor)));
        for (std::size_t i = 0; i < made.pixels.size(); ++i)
            CHECK(made.pixels[i].r == Approx(factor * right.pixels[i].r).margin(1e-6));
    }
    for (const Rgb& pixel : smooth.picture(std::vector<Rgb>(4, Rgb(0))).pixels)
        CHECK(pixel == Rgb(0));
}

TEST_CASE("samples of lamps in a smooth crowd count for all that is around them", "[relight]") {
    LightRecords records = records_of([](int, int) { return Look{1, 0.5, Vec3(0, 1, 0)}; });
    // The first lamp has all of the light of its node.
    for (std::size_t i = 0; i < records.tiles.size(); ++i) {
        const int across = records.tiles_across(), column = static_cast<int>(i) % across,
                  row = static_cast<int>(i) / across;
        const auto light = static_cast<float>(std::min(light_tile, columns - column * light_tile) *
                                              std::min(light_tile, rows - row * light_tile)) /
                           2;
        records.tiles[i].residual = {{0, 0, false, {light, light, light}}};
    }
    const Relighting smooth(records, 4, 1);
    const Image only = smooth.picture(std::vector<Rgb>{Rgb(1), Rgb(0), Rgb(0), Rgb(0)}),
                other = smooth.picture(std::vector<Rgb>{Rgb(0), Rgb(1), Rgb(0), Rgb(0)});
    CHECK(only.at(20, 13).r == Approx(0.5).epsilon(0.1));
    CHECK(only.at(17, 10).r == Approx(0.5).epsilon(0.1));
    CHECK(other.at(20, 13).r == Approx(0).margin(0.05));
}

TEST_CASE("tiles with lamps that are seen in crowds stay sharp", "[relight]") {
    LightRecords records = records_of([](int x, int y) {
        return Look{1, (x + y) % 2 == 0 ? 1.0 : 0.0, Vec3(0, 0, 1)};
    });
    records.tiles[3].seen_in_nodes = true;
    records.tiles[3].residual = {{0, 0, false, {0.5, 0.5, 0.5}}};
    const Image made = Relighting(records, 4, 1).picture(first_node),
                right = relit(records, first_node, 1);
    for (int y = 0; y < light_tile; ++y)
        for (int x = 3 * light_tile; x < 4 * light_tile; ++x)
            CHECK(made.at(x, y) == right.at(x, y));
    CHECK(made.at(20, 4).r == Approx(0.5).margin(0.1));
}

TEST_CASE("a smooth picture does not depend on threads", "[relight]") {
    const LightRecords records = records_of([](int x, int y) {
        return Look{random(x, y), random(y, x), Vec3(0, 1, 0)};
    });
    CHECK(Relighting(records, 4, 1).picture(first_node).pixels ==
          Relighting(records, 4, 3).picture(first_node).pixels);
}

TEST_CASE("light below nothing and none at all leave a smooth picture finite", "[relight]") {
    const LightRecords records = records_of([](int x, int y) {
        return Look{x < 10 ? 0 : random(x, y) - 0.5, 2 * random(y, x), Vec3(0, 1, 0)};
    });
    for (const Rgb& pixel : Relighting(records, 4, 1).picture(first_node).pixels)
        CHECK(std::abs(pixel.r) < 10);
}

}  // namespace candelabra
