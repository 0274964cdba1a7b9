// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/voronoi.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

double area(const std::vector<Vec2>& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        sum += 0.5 * (a.x * b.y - a.y * b.x);
    }
    return sum;
}

}  // namespace

TEST_CASE("cells tile the rectangle", "[modelling]") {
    Draw draw(1);
    std::vector<Vec2> points;
    for (int i = 0; i < 100; ++i) points.emplace_back(draw.between(-1, 2), draw.between(0, 1));
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto cell = voronoi_cell(points, i, Vec2(-1, 0), Vec2(2, 1));
        REQUIRE(cell.size() >= 3);
        CHECK(area(cell) > 0);
        sum += area(cell);
        for (const Vec2& corner : cell)
            for (const Vec2& other : points)
                CHECK(glm::distance(corner, points[i]) < glm::distance(corner, other) + 1e-9);
    }
    CHECK(sum == Approx(3));
}

TEST_CASE("a point alone has all, and one of two at a place nothing", "[modelling]") {
    const std::vector<Vec2> one = {Vec2(0.3)}, twice = {Vec2(0.3), Vec2(0.3)};
    CHECK(area(voronoi_cell(one, 0, Vec2(0), Vec2(2))) == Approx(4));
    CHECK(voronoi_cell(twice, 0, Vec2(0), Vec2(2)).empty());
    const std::vector<Vec2> row = {Vec2(5, 0), Vec2(1, 0)};
    CHECK(voronoi_cell(row, 0, Vec2(0), Vec2(2)).empty());
}

}  // namespace candelabra
