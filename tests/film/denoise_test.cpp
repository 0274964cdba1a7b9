// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/denoise.h"

#include "base/random.h"
#include "support/rgb.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

constexpr int side = 48;

/// A floor with a pattern under light that falls off with distance, a wall, and the sky above.
struct QuietView {
    Image light{side, side}, albedo{side, side}, normal{side, side};
    std::vector<double> depth;

    QuietView() {
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const bool sky = y < 8, wall = y < 20;
                const bool dark = (x / 6 + y / 6) % 2 == 0;
                const double away = std::hypot(x - 30, y - 40) / 20;
                albedo.at(x, y) = sky ? Rgb(0) : wall ? Rgb(0.6, 0.5, 0.4) : Rgb(dark ? 0.2 : 0.7);
                normal.at(x, y) = sky ? Rgb(0) : wall ? Rgb(0, 0, -1) : Rgb(0, 1, 0);
                light.at(x, y) = sky ? Rgb(0.1, 0.1, 0.3) : albedo.at(x, y) / (1 + away * away);
                depth.push_back(sky ? INFINITY : wall ? 10 : 10 - 0.2 * (y - 20));
            }
    }
};

/// Returns the view with samples of noisy light in each pixel.
NoisyPicture noisy(const QuietView& view, int samples, double noise = 1) {
    NoisyPicture made;
    made.light = view.light;
    made.glow = made.variance = Image(side, side);
    made.albedo = view.albedo;
    made.normal = view.normal;
    made.depth = view.depth;
    std::uint64_t n = 0;
    for (std::size_t i = 0; i < made.light.pixels.size(); ++i) {
        Rgb sum(0), squares(0);
        for (int k = 0; k < samples; ++k) {
            // Mostly small, occasionally large, with mean 1.
            const double chance = static_cast<double>(mix(++n) >> 11) * 0x1p-53;
            const double factor = 1 + noise * (3 * chance * chance - 1);
            const Rgb sample = factor * view.light.pixels[i];
            sum += sample;
            squares += sample * sample;
        }
        const Rgb mean = sum / static_cast<double>(samples);
        made.light.pixels[i] = mean;
        made.variance.pixels[i] =
            max(squares / static_cast<double>(samples) - mean * mean, Rgb(0)) /
            std::max(samples - 1.0, 1.0);
    }
    return made;
}

double error_of(const Image& made, const Image& exact) {
    double sum = 0;
    for (std::size_t i = 0; i < made.pixels.size(); ++i) {
        const Rgb off = made.pixels[i] - exact.pixels[i];
        sum += length(off) * length(off);
    }
    return std::sqrt(sum / static_cast<double>(made.pixels.size()));
}

}  // namespace

TEST_CASE("a picture has less noise when it is denoised", "[film][denoise]") {
    const QuietView view;
    const NoisyPicture four = noisy(view, 4);
    CHECK(error_of(denoised(four, 1).light, view.light) < 0.4 * error_of(four.light, view.light));
    const NoisyPicture many = noisy(view, 64);
    CHECK(error_of(denoised(many, 1).light, view.light) < 0.7 * error_of(many.light, view.light));
}

TEST_CASE("the denoised picture becomes the exact one as samples grow", "[film][denoise]") {
    const QuietView view;
    double before = 1e9;
    for (const int samples : {4, 32, 256, 2048}) {
        const NoisyPicture picture = noisy(view, samples);
        const double error = error_of(denoised(picture, 1).light, view.light);
        INFO(samples << " samples: " << error);
        CHECK(error < 0.75 * before);
        before = error;
    }
    NoisyPicture exact = noisy(view, 2, 0);
    const Image made = denoised(exact, 1).light;
    for (std::size_t i = 0; i < made.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            CHECK(made.pixels[i][c] == Approx(view.light.pixels[i][c]).epsilon(1e-3).margin(1e-5));
}

TEST_CASE("edges of surfaces and of shadows stay", "[film][denoise]") {
    QuietView view;
    // A lamp without noise, and a shadow on the floor with the same noise as the rest.
    for (int y = 24; y < 44; ++y)
        for (int x = 4; x < 16; ++x) view.light.at(x, y) *= 0.05;
    for (int y = 2; y < 6; ++y)
        for (int x = 20; x < 24; ++x) view.light.at(x, y) = Rgb(500);
    const Image made = denoised(noisy(view, 16), 1).light;
    for (int y = 26; y < 42; ++y) {
        CHECK(made.at(14, y).r < 3 * view.light.at(14, y).r);
        CHECK(made.at(18, y).r > 0.5 * view.light.at(18, y).r);
    }
    CHECK(made.at(19, 4).r < 0.5);
    CHECK(made.at(21, 4).r > 250);
}

TEST_CASE("what glows stays as it is, and its neighbours do not get its light",
          "[film][denoise]") {
    const QuietView view;
    NoisyPicture picture = noisy(view, 4);
    const NoisyPicture dark = picture;
    // A small lamp, which covers a noisy share of its pixels.
    for (int y = 30; y < 33; ++y)
        for (int x = 30; x < 33; ++x) {
            picture.glow.at(x, y) = Rgb(x == 31 && y == 31 ? 90 : 22.5 * ((x + y) % 3));
            picture.light.at(x, y) += picture.glow.at(x, y);
        }
    picture.parts = {picture.light};
    const QuietPicture made = denoised(picture, 1);
    const Image without = denoised(dark, 1).light;
    for (std::size_t i = 0; i < made.light.pixels.size(); ++i) {
        const Rgb expected = without.pixels[i] + picture.glow.pixels[i];
        CHECK(made.light.pixels[i].r == Approx(expected.r));
        CHECK(made.parts[0].pixels[i].r == Approx(expected.r));
    }
}

TEST_CASE("a bright pixel that chance has made does not spread", "[film][denoise]") {
    const QuietView view;
    NoisyPicture picture = noisy(view, 4);
    picture.light.at(30, 30) = Rgb(50);
    picture.variance.at(30, 30) = Rgb(2500);
    const Image made = denoised(picture, 1).light;
    for (int y = 25; y < 36; ++y)
        for (int x = 25; x < 36; ++x)
            if (x != 30 || y != 30) CHECK(made.at(x, y).r < 1.5);
}

TEST_CASE("a denoised picture does not depend on threads, and one sample is left alone",
          "[film][denoise]") {
    const QuietView view;
    const NoisyPicture picture = noisy(view, 4);
    CHECK(denoised(picture, 1).light.pixels == denoised(picture, 3).light.pixels);
    const NoisyPicture one = noisy(view, 1);
    const Image made = denoised(one, 1).light;
    CHECK(error_of(made, one.light) < 0.1 * error_of(one.light, view.light));
    CHECK(denoised(NoisyPicture(), 1).light.pixels.empty());
}

TEST_CASE("parts of the light are denoised with it, and are the light together",
          "[film][denoise]") {
    const QuietView view;
    NoisyPicture picture = noisy(view, 4);
    picture.parts.assign(2, picture.light);
    for (std::size_t i = 0; i < picture.light.pixels.size(); ++i) {
        picture.parts[0].pixels[i] = 0.25 * picture.light.pixels[i] + Rgb(0.01, 0, 0);
        picture.parts[1].pixels[i] = picture.light.pixels[i] - picture.parts[0].pixels[i];
    }
    const QuietPicture made = denoised(picture, 2);
    REQUIRE(made.parts.size() == 2);
    CHECK(made.light.pixels == denoised(noisy(view, 4), 1).light.pixels);
    for (std::size_t i = 0; i < made.light.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            CHECK(made.parts[0].pixels[i][c] + made.parts[1].pixels[i][c] ==
                  Approx(made.light.pixels[i][c]).margin(1e-12));
}

}  // namespace candelabra
