// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/fft.h"

#include "base/random.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

ComplexPlane random_plane(std::size_t width, std::size_t height) {
    ComplexPlane plane(width, height);
    std::uint64_t n = 0;
    for (Complex& value : plane.values) {
        const auto next = [&] { return static_cast<double>(mix(++n) >> 11) * 0x1p-53; };
        value.re = next();
        value.im = next();
    }
    return plane;
}

Complex by_definition(const ComplexPlane& plane, std::size_t u, std::size_t v) {
    Complex sum;
    for (std::size_t y = 0; y < plane.height; ++y)
        for (std::size_t x = 0; x < plane.width; ++x) {
            const double turns = static_cast<double>(u * x) / static_cast<double>(plane.width) +
                                 static_cast<double>(v * y) / static_cast<double>(plane.height);
            const double angle = -2 * std::numbers::pi * turns;
            sum = sum + plane.at(x, y) * Complex{std::cos(angle), std::sin(angle)};
        }
    return sum;
}

}  // namespace

TEST_CASE("a transform is the sum that defines it", "[base][fft]") {
    for (const auto& [width, height] :
         {std::pair<std::size_t, std::size_t>{12, 10}, {2, 30}, {16, 8}, {20, 18}}) {
        const ComplexPlane plane = random_plane(width, height);
        ComplexPlane made = plane;
        transform_forward(made, 1);
        REQUIRE(made.width == height);
        for (std::size_t u = 0; u < width; ++u)
            for (std::size_t v = 0; v < height; ++v) {
                const Complex wanted = by_definition(plane, u, v);
                CHECK(made.at(v, u).re == Approx(wanted.re).margin(1e-11));
                CHECK(made.at(v, u).im == Approx(wanted.im).margin(1e-11));
            }
    }
}

TEST_CASE("a transform back gives what was there, by any number of threads", "[base][fft]") {
    const ComplexPlane plane = random_plane(90, 64);
    ComplexPlane one = plane, three = plane;
    transform_forward(one, 1);
    transform_forward(three, 3);
    CHECK(one.values == three.values);
    transform_back(one, 1);
    REQUIRE(one.width == plane.width);
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        CHECK(one.values[i].re == Approx(plane.values[i].re).margin(1e-13));
        CHECK(one.values[i].im == Approx(plane.values[i].im).margin(1e-13));
    }
}

TEST_CASE("sizes of transforms are even and have small factors", "[base][fft]") {
    CHECK(fft_size(0) == 2);
    CHECK(fft_size(1) == 2);
    CHECK(fft_size(7) == 8);
    CHECK(fft_size(9) == 10);
    CHECK(fft_size(1279) == 1280);
    CHECK(fft_size(2049) == 2160);
    for (std::size_t n = 2; n < 500; ++n) CHECK(fft_size(n) >= n);
}

}  // namespace candelabra
