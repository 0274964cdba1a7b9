// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/pixel_filter.h"

#include "base/random.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

constexpr auto wide_filters = {FilterShape::triangle, FilterShape::mitchell,
                               FilterShape::blackman_harris};

}  // namespace

TEST_CASE("filters have an integral of 1", "[film][filter]") {
    for (const FilterShape shape : {FilterShape::box, FilterShape::triangle, FilterShape::mitchell,
                                    FilterShape::blackman_harris}) {
        double sum = 0;
        constexpr int steps = 40000;
        for (int i = 0; i < steps; ++i)
            sum += PixelFilter::height(shape, 5.0 * (i + 0.5) / steps - 2.5) * 5.0 / steps;
        CHECK(sum == Approx(1).epsilon(1e-3));
    }
    CHECK(PixelFilter::height(FilterShape::mitchell, 0) == Approx(16.0 / 18));
    CHECK(PixelFilter::height(FilterShape::mitchell, 1) == Approx(1.0 / 18));
    CHECK(PixelFilter::height(FilterShape::mitchell, 1.5) < 0);
    CHECK(PixelFilter::height(FilterShape::triangle, 0.25) == Approx(0.75));
    CHECK(PixelFilter::height(FilterShape::blackman_harris, 1.5) == Approx(0).margin(1e-4));
}

TEST_CASE("a box leaves samples where they are", "[film][filter]") {
    const FilteredPlace place = PixelFilter(FilterShape::box).place(0.3, 0.7, 5);
    CHECK(place.place == Vec2(0.3, 0.7));
    CHECK_FALSE(place.negative);
}

TEST_CASE("samples are as dense as the filter is high", "[film][filter]") {
    for (const FilterShape shape : wide_filters) {
        const PixelFilter filter(shape);
        // Of the columns and rows of a quarter of a pixel, signed.
        constexpr int cells = 20;
        double across[cells] = {}, down[cells] = {};
        double weight = 0;
        constexpr std::uint32_t count = 400000;
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto random = [&](std::uint64_t n) {
                return static_cast<double>(mix(2 * std::uint64_t{i} + n) >> 11) * 0x1p-53;
            };
            const FilteredPlace one = filter.place(random(0), random(1), i);
            const double sign = one.negative ? -1 : 1;
            weight += sign;
            across[static_cast<int>(std::floor((one.place.x - 0.5) * 4)) + cells / 2] += sign;
            down[static_cast<int>(std::floor((one.place.y - 0.5) * 4)) + cells / 2] += sign;
        }
        for (int i = 0; i < cells; ++i) {
            double wanted = 0;
            for (int k = 0; k < 50; ++k)
                wanted +=
                    PixelFilter::height(shape, ((i - cells / 2) + (k + 0.5) / 50) / 4) / 4 / 50;
            CHECK(across[i] / weight == Approx(wanted).margin(0.004));
            CHECK(down[i] / weight == Approx(wanted).margin(0.004));
        }
    }
}

TEST_CASE("all pixels have as many samples below zero, and never too many", "[film][filter]") {
    const PixelFilter mitchell(FilterShape::mitchell);
    int negative = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        negative += mitchell.place(0.3, 0.4, i).negative;
        CHECK(mitchell.place(0.9, 0.1, i).negative == mitchell.place(0.3, 0.4, i).negative);
        CHECK(2 * negative < static_cast<int>(i) + 1);
    }
    CHECK(negative > 50);
    CHECK(negative < 200);
    for (std::uint32_t i = 0; i < 1000; ++i)
        CHECK_FALSE(PixelFilter(FilterShape::triangle).place(0.3, 0.4, i).negative);
}

}  // namespace candelabra
