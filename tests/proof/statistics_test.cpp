// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/statistics.h"

#include "proof/dice.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra::proof {

namespace {

/// Pixels that are rarely bright, as those of a lamp that is found by chance.
Image rare_light(Dice& dice, double mean, double probability) {
    Image image(24, 18);
    for (Rgb& each : image.pixels) each = Rgb(dice.chance(probability) ? mean / probability : 0.0);
    return image;
}

}  // namespace

TEST_CASE("noise without a difference is hardly ever beyond four", "[proof]") {
    Dice dice(3);
    int beyond = 0;
    for (int run = 0; run < 200; ++run) {
        Comparison comparison(0);
        for (int batch = 0; batch < 4; ++batch)
            comparison.add(rare_light(dice, 1, 0.1), rare_light(dice, 1, 0.1));
        beyond += std::abs(comparison.t(comparison.worst())) > 4;
    }
    CHECK(beyond <= 4);
}

TEST_CASE("a difference of a tenth is found in the picture and in its batches", "[proof]") {
    Dice dice(4);
    Comparison comparison(1e-3);
    for (int batch = 0; batch < 32; ++batch)
        comparison.add(rare_light(dice, 1.1, 0.3), rare_light(dice, 1, 0.3));
    const std::size_t region = whole * 3;
    CHECK(comparison.t(region) > 4);
    CHECK(comparison.spread(region).t > 3);
    CHECK(comparison.spread(region).same_sign >= 12);
}

TEST_CASE("a difference in one block is found there", "[proof]") {
    Dice dice(5);
    Comparison comparison(1e-3);
    for (int batch = 0; batch < 16; ++batch) {
        Image dark = rare_light(dice, 1, 0.5);
        for (int y = 0; y < 4; ++y)
            for (int x = 6; x < 12; ++x) dark.at(x, y) *= 0.5;
        comparison.add(rare_light(dice, 1, 0.5), dark);
    }
    CHECK(comparison.worst() / 3 == 1);
    CHECK(comparison.t(comparison.worst()) > 4);
}

TEST_CASE("a black picture may have missed what hardly ever comes", "[proof]") {
    for (const double dim : {1e-4, 0.01}) {
        Comparison comparison(0);
        for (int batch = 0; batch < 16; ++batch) {
            Image left(24, 18), right(24, 18);
            for (Rgb& each : left.pixels) each = Rgb(dim);
            left.pixels[0] = right.pixels[0] = Rgb(3);  // a lamp that both see
            comparison.add(left, right);
        }
        // The last block has 6 x 4 or 5 pixels, 16 samples each, in 16 batches.
        CHECK(comparison.too_rare((whole - 1) * 3, 16) == (dim < 0.001));
        CHECK_FALSE(comparison.too_rare(0, 16));  // the block with the lamp
    }
}

TEST_CASE("a picture may have missed what hardly ever comes beside what always does", "[proof]") {
    for (const double noise : {0.0, 1e-3}) {
        Dice dice(8);
        Comparison comparison(0);
        for (int batch = 0; batch < 16; ++batch) {
            Image left(24, 18), right(24, 18);
            for (Rgb& each : left.pixels) each = Rgb(3e-4);
            for (Rgb& each : right.pixels) each = Rgb(1e-4 + (dice.chance(0.05) ? noise : 0));
            left.pixels[0] = right.pixels[0] = Rgb(3);  // a lamp that both see
            comparison.add(left, right);
        }
        CHECK_FALSE(comparison.too_rare((whole - 1) * 3, 16));
        CHECK(comparison.lacks_rare((whole - 1) * 3, 16));
    }
    Dice dice(9);
    Comparison noisy(0), brighter(0);
    for (int batch = 0; batch < 16; ++batch) {
        Image left(24, 18), right(24, 18);
        for (Rgb& each : left.pixels) each = Rgb(0.004);
        for (Rgb& each : right.pixels) each = Rgb(dice.chance(0.05) ? 0.04 : 0);
        left.pixels[0] = right.pixels[0] = Rgb(3);
        noisy.add(left, right);
        brighter.add(right, left);
    }
    CHECK_FALSE(noisy.lacks_rare((whole - 1) * 3, 16));
    CHECK_FALSE(brighter.lacks_rare((whole - 1) * 3, 16));
}

TEST_CASE("equal pictures, and those within the tolerance, do not differ", "[proof]") {
    Dice dice(6);
    Comparison comparison(1e-2);
    const Image image = rare_light(dice, 1, 0.4);
    Image other = image;
    for (Rgb& each : other.pixels) each *= 1.005;
    comparison.add(image, other);
    CHECK(comparison.t(comparison.worst()) == 0);
}

TEST_CASE("what is no number differs from everything", "[proof]") {
    Comparison comparison(1e-2);
    Image image(24, 18);
    const Image black = image;
    image.at(3, 3).g = std::nan("");
    comparison.add(image, black);
    CHECK(std::isinf(comparison.t(comparison.worst())));
}

}  // namespace candelabra::proof
