// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/auto_exposure.h"

#include "base/random.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace candelabra {

namespace {

constexpr double usual_key = 0.18;

Image grey_picture(double light) {
    Image image(20, 10);
    for (Rgb& pixel : image.pixels) pixel = Rgb(light);
    return image;
}

double chance(std::uint64_t n) { return static_cast<double>(mix(n) >> 11) * 0x1p-53; }

/// A street at night: the ground, a moving and blinking lamp, and noise.
Image street(int frame) {
    Image image(160, 90);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double away = std::hypot(x - 20 - frame, y - 30);
            const double noise =
                0.5 + chance(static_cast<std::uint64_t>((frame * 90 + y) * 160 + x));
            image.at(x, y) = Rgb(0.9, 0.7, 0.4) * noise * (0.02 + 2 / (20 + away * away));
            const bool lit = (frame / 3 + y / 30) % 2 == 0;
            if (lit && away < 4) image.at(x, y) = Rgb(500);
        }
    return image;
}

}  // namespace

TEST_CASE("an even picture is exposed as a middle grey, and night stays dark", "[film]") {
    CHECK(stops_asked_by(grey_picture(0.18), usual_key) == Approx(0).margin(1e-6));
    CHECK(stops_asked_by(grey_picture(1.8), usual_key) == Approx(-std::log2(10)).margin(1e-6));
    // One stop of 4 (1 - exp(-1 / 4)).
    CHECK(stops_asked_by(grey_picture(0.09), usual_key) == Approx(0.8848).margin(1e-3));
    CHECK(stops_asked_by(grey_picture(1e-9), usual_key) == Approx(4).margin(0.01));
    CHECK(stops_asked_by(grey_picture(0), usual_key) == Approx(4).margin(0.01));
    CHECK(stops_asked_by(grey_picture(1e300), usual_key) == Approx(-20).margin(1e-6));
    CHECK(stops_asked_by(Image(), usual_key) == 0);
}

TEST_CASE("strange pixels do not count in an exposure", "[film]") {
    Image image = grey_picture(0.18);
    const double usual = stops_asked_by(image, usual_key);
    image.at(3, 3) = Rgb(NAN);
    image.at(4, 4) = Rgb(std::numeric_limits<double>::infinity());
    image.at(5, 5) = Rgb(-1e9);
    CHECK(stops_asked_by(image, usual_key) == Approx(usual).margin(0.05));
}

TEST_CASE("the exposure of an animation does not flicker with lamps that do", "[film]") {
    double least = 1e9, greatest = -1e9, before = stops_asked_by(street(0), usual_key);
    for (int frame = 1; frame < 60; ++frame) {
        const double stops = stops_asked_by(street(frame), usual_key);
        CHECK(std::abs(stops - before) < 0.05);
        least = std::min(least, stops);
        greatest = std::max(greatest, stops);
        before = stops;
    }
    CHECK(greatest - least < 0.2);
}

}  // namespace candelabra
