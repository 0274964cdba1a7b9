// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/relighting.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Two tiles beside each other, the second of them one pixel wide.
LightRecords two_tiles() {
    LightRecords records;
    records.width = 9;
    records.height = 2;
    records.lamps = LampList({{"A", 1}, {"B", 2}}, {0, 0, 1}, {1, 1, 3});
    records.tiles.resize(2);
    std::vector<TilePlanes> light(1);
    light[0].fill(2);
    records.tiles[0].nodes = {{1, 3}};
    records.tiles[0].own = {{0, 9, false, {1, 0, 0}}};
    records.tiles[0].residual = {{1, 10, false, {4, 4, 4}}};
    round_to_file(records.tiles[0], light);
    records.tiles[1].rest.emplace();
    (*records.tiles[1].rest)[0] = 0.5F;
    return records;
}

}  // namespace

TEST_CASE("a picture is the sum of its records with their factors", "[relight]") {
    const LightRecords records = two_tiles();
    const Image same = relit(records, std::vector<Rgb>(3, Rgb(1)), 1);
    CHECK(same.at(0, 0) == Rgb(2));
    CHECK(same.at(1, 1) == Rgb(3, 2, 2));
    CHECK(same.at(2, 1) == Rgb(2));  // equal factors: no residual
    CHECK(same.at(8, 0) == Rgb(0.5, 0, 0));
    // The second lamp of the node has three quarters of its power.
    const std::vector<Rgb> factors = {Rgb(0, 1, 1), Rgb(1), Rgb(0, 1, 2)};
    const Image other = relit(records, factors, 2);
    CHECK(other.at(0, 0) == Rgb(0.5, 2, 3.5));
    CHECK(other.at(1, 1) == Rgb(0.5, 2, 3.5));
    CHECK(other.at(2, 1) == Rgb(0.5 + 4 * 0.75, 2, 3.5 - 4 * 0.75));
    CHECK(other.at(8, 0) == Rgb(0.5, 0, 0));
}

TEST_CASE("light of crowds may be smooth, and lamps by themselves stay as they are", "[relight]") {
    const LightRecords records = two_tiles();
    const Relighting smooth(records, 4, 2);
    CHECK(smooth.picture(std::vector<Rgb>(3, Rgb(1))).at(2, 1).r == Approx(2));
    CHECK(smooth.picture(std::vector<Rgb>(3, Rgb(1))).at(1, 1).r == Approx(3));
    // The residual of one pixel is that of all around it.
    const std::vector<Rgb> factors = {Rgb(0), Rgb(1), Rgb(0)};
    const Image sharp = relit(records, factors, 1), made = smooth.picture(factors);
    CHECK(sharp.at(2, 1).r == Approx(0.5 + 4 * 0.75));
    CHECK(sharp.at(5, 1).r == Approx(0.5));
    CHECK(made.at(2, 1).r < 1);
    CHECK(made.at(5, 1).r > 0.55);
    double sum = 0, right = 0;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 8; ++x) {
            sum += made.at(x, y).r;
            right += sharp.at(x, y).r;
        }
    CHECK(sum == Approx(right).epsilon(0.3));
    CHECK(smooth.picture(std::vector<Rgb>(3, Rgb(0))).at(1, 1) == Rgb(0));
}

TEST_CASE("without light the picture is black", "[relight]") {
    LightRecords records = two_tiles();
    records.tiles[1].rest.reset();
    for (const Rgb& pixel : relit(records, std::vector<Rgb>(3, Rgb(0)), 1).pixels)
        CHECK(pixel == Rgb(0));
}

}  // namespace candelabra
