// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/pixel_filter.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

constexpr auto wide_filters = {FilterShape::triangle, FilterShape::mitchell,
                               FilterShape::blackman_harris};

/// A smooth function plus an edge.
double seen_at(const Vec2& place) {
    return (place.x + 0.4 * place.y < 0.6 ? 1 : 0) + std::sin(place.x - 2 * place.y);
}

/// Mean and standard deviation of estimates with this many samples, over many pixels.
struct Means {
    double mean = 0, deviation = 0;
};
template <class Place>
Means means_of(std::uint32_t samples, const Place& place) {
    constexpr int pixels = 1000;
    Means means;
    double squares = 0;
    for (std::uint64_t pixel = 0; pixel < pixels; ++pixel) {
        double sum = 0, weight = 0;
        for (std::uint32_t i = 0; i < samples; ++i) {
            const FilteredPlace one = place(Key{mix(pixel), i});
            sum += (one.negative ? -1 : 1) * seen_at(one.place);
            weight += one.negative ? -1 : 1;
        }
        means.mean += sum / weight / pixels;
        squares += sum / weight * (sum / weight) / pixels;
    }
    means.deviation = std::sqrt(squares - means.mean * means.mean);
    return means;
}

double filtered(FilterShape shape) {
    double sum = 0, weight = 0;
    constexpr int steps = 1000;
    for (int row = 0; row < steps; ++row)
        for (int column = 0; column < steps; ++column) {
            const Vec2 from_middle =
                4.0 * (Vec2(column, row) + 0.5) / static_cast<double>(steps) - 2.0;
            const double height = PixelFilter::height(shape, from_middle.x) *
                                  PixelFilter::height(shape, from_middle.y);
            sum += height * seen_at(from_middle + 0.5);
            weight += height;
        }
    return sum / weight;
}

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
    const Key key{3, 5};
    const FilteredPlace place = PixelFilter(FilterShape::box).place(key);
    CHECK(place.place == Vec2(uniform(key, Purpose::pixel_x), uniform(key, Purpose::pixel_y)));
    CHECK_FALSE(place.negative);
}

TEST_CASE("samples are as dense as the filter is high", "[film][filter]") {
    for (const FilterShape shape : wide_filters) {
        const PixelFilter filter(shape);
        // Signed weights of columns and rows, each a quarter of a pixel wide.
        constexpr int cells = 20;
        double across[cells] = {}, down[cells] = {};
        double weight = 0;
        constexpr std::uint32_t count = 400000;
        for (std::uint32_t i = 0; i < count; ++i) {
            const FilteredPlace one = filter.place({mix(i), i});
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

TEST_CASE("samples are spread evenly over each filter, and show what it shows", "[film][filter]") {
    for (const FilterShape shape : wide_filters) {
        const PixelFilter filter(shape);
        constexpr std::uint32_t samples = 64;
        const auto even = [&](const Key& key) { return filter.place(key); };
        const Means means = means_of(samples, even);
        CHECK(means.mean == Approx(filtered(shape)).margin(0.004));
        // The same, with independent samples: each from a different pixel.
        const auto random = [&](const Key& key) {
            return filter.place({mix(key.pixel ^ mix(key.sample)), key.sample});
        };
        CHECK(means.deviation < 0.4 * means_of(samples, random).deviation);
    }
}

TEST_CASE("all pixels have as many samples below zero, and never too many", "[film][filter]") {
    const PixelFilter mitchell(FilterShape::mitchell);
    int negative = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        negative += mitchell.place({1, i}).negative;
        CHECK(mitchell.place({2, i}).negative == mitchell.place({1, i}).negative);
        CHECK(2 * negative < static_cast<int>(i) + 1);
    }
    CHECK(negative > 50);
    CHECK(negative < 200);
    for (std::uint32_t i = 0; i < 1000; ++i)
        CHECK_FALSE(PixelFilter(FilterShape::triangle).place({1, i}).negative);
}

}  // namespace candelabra
