// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/lens_shape.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

/// Calls f for points of a grid of random numbers.
template <class F>
void for_places(int first, int second, const F& f) {
    for (int i = 0; i < first; ++i)
        for (int j = 0; j < second; ++j) f(Vec2((i + 0.5) / first, (j + 0.5) / second));
}

}  // namespace

TEST_CASE("points of a polygon are uniform in it", "[camera]") {
    for (const int blades : {3, 4, 5, 6, 8})
        for (const double angle : {0.0, 17.0}) {
            CAPTURE(blades, angle);
            const LensShape shape(Bokeh{blades, angle});
            CHECK_FALSE(shape.is_round());
            constexpr int parts = 400;
            Vec2 sum(0);
            double moment = 0;
            const double inner = std::cos(std::numbers::pi / blades);  // radius of the edges
            int within = 0;
            for_places(parts, parts, [&](Vec2 place) {
                const Vec2 p = shape.point(place);
                sum += p;
                moment += glm::dot(p, p);
                CHECK_FALSE(glm::dot(p, p) > 1 + 1e-12);
                within += glm::dot(p, p) < inner * inner;
            });
            const double count = parts * parts;
            CHECK(glm::length(sum) / count < 1e-3);
            // Area of the polygon, and its moment around the middle.
            const double turn = 2 * std::numbers::pi / blades;
            const double area = blades / 2.0 * std::sin(turn);
            CHECK(within / count == Approx(std::numbers::pi * inner * inner / area).margin(2e-3));
            CHECK(moment / count == Approx((2 + std::cos(turn)) / 6).margin(1e-3));
        }
    // A corner points upwards, and turns counter-clockwise.
    CHECK(LensShape(Bokeh{5, 0}).point({1, 0}).y == Approx(1));
    CHECK(LensShape(Bokeh{5, 90}).point({1, 0}).x == Approx(-1));
}

TEST_CASE("an opening of fewer than three corners is round", "[camera]") {
    for (const LensShape& shape : {LensShape(), LensShape(Bokeh{2, 30}),
                                   LensShape(std::vector<double>(lens_cells * lens_cells, 0.0))}) {
        CHECK(shape.is_round());
        CHECK(glm::length(shape.point({1, 0.3})) == Approx(1));
        CHECK(glm::length(shape.point({0.25, 0.8})) == Approx(0.5));
    }
}

TEST_CASE("points of a picture are as frequent as it is bright", "[camera]") {
    // Three times as bright on the right as on the left, and dark in the lower half.
    std::vector<double> brightness;
    for (int row = 0; row < lens_cells; ++row)
        for (int column = 0; column < lens_cells; ++column)
            brightness.push_back(row < lens_cells / 2 ? -1 : column < lens_cells / 2 ? 1 : 3);
    const LensShape shape(brightness);
    CHECK(shape.is_picture());
    constexpr int first = 1024, second = 32;  // sixteen in each row of the picture
    int right = 0;
    double height = 0;
    for_places(first, second, [&](Vec2 place) {
        const Vec2 p = shape.point(place);
        CHECK_FALSE((p.y < 0 || p.y > 1 || std::abs(p.x) > 1));
        right += p.x > 0;
        height += p.y;
    });
    CHECK(right / double(first * second) == Approx(0.75).margin(2e-3));
    CHECK(height / double(first * second) == Approx(0.5).margin(2e-3));
}

}  // namespace candelabra
