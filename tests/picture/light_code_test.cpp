// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/light_code.h"

#include "base/random.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// A picture with a bright lamp, a slope, darkness and some noise.
Image room(int width, int height, double noise = 0.02) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto chance =
                static_cast<double>(mix(static_cast<std::uint64_t>(y * width + x)) >> 11) * 0x1p-53;
            const double slope = static_cast<double>(x) / width;
            image.at(x, y) = Rgb(slope, slope * slope, 0.1) * (1 + noise * (chance - 0.5));
            if (std::hypot(x - width / 3.0, y - height / 2.0) < height / 5.0)
                image.at(x, y) = Rgb(5000, 400, 20);
        }
    return image;
}

}  // namespace

TEST_CASE("coarser steps of a light code have fewer bytes, whatever the size of the picture") {
    for (const auto& [width, height] : {std::pair{64, 48}, {65, 47}, {1, 1}, {3, 200}, {17, 16}}) {
        CAPTURE(width, height);
        const Image image = room(width, height);
        const LightCode fine = light_code({&image, 1}, finest_light_step);
        const LightCode coarse = light_code({&image, 1}, 1);
        CHECK(fine.bytes.size() >= coarse.bytes.size());
        CHECK(fine.levels == coarse.levels);
        if (width * height > 1000) CHECK(fine.bytes.size() > 2 * coarse.bytes.size());
    }
}

TEST_CASE("a light code has as many levels as the picture has room for") {
    const auto levels = [](int width, int height) {
        const Image image(width, height);
        return light_code({&image, 1}, 1).levels;
    };
    CHECK(levels(1, 1) == 0);
    CHECK(levels(15, 4000) == 0);
    CHECK(levels(16, 16) == 1);
    CHECK(levels(64, 48) == 2);
    CHECK(levels(2000, 1500) == 6);
}

TEST_CASE("a light code keeps within its bytes, and uses them") {
    const Image images[] = {room(128, 96, 0.5), room(128, 96, 0.1)};
    const LightCode finest = light_code(images, finest_light_step);
    const std::size_t all = finest.bytes.size();
    for (const std::size_t room : {all, all / 2, all / 5, all / 20}) {
        const LightCode made = light_code_within(images, room);
        CAPTURE(room, made.bytes.size(), made.step);
        CHECK(made.bytes.size() <= room);
        CHECK(made.bytes.size() > room * 3 / 5);
        CHECK(made.step >= finest_light_step);
    }
    CHECK(light_code_within(images, all).step == finest_light_step);
    // Nothing has room in no bytes: the coarsest one.
    CHECK(light_code_within(images, 0).step == 8);
}

TEST_CASE("a light code takes values that are no light, and does not depend on threads") {
    Image odd = room(40, 30);
    odd.pixels[3] = Rgb(-1, std::nan(""), INFINITY);
    odd.pixels[4] = Rgb(1e300, 0, -INFINITY);
    const Image images[] = {odd, room(40, 30)};
    const LightCode one = light_code(images, 0.1, 1), four = light_code(images, 0.1, 4);
    CHECK(one.bytes == four.bytes);
    CHECK(one.bytes.size() > 100);
    CHECK(light_code({}, 1).levels == 0);
}

}  // namespace candelabra
