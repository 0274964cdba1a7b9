// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/outline.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Outline outline(CurveKind kind, const std::vector<Vec2>& points) {
    return Outline(closed_curves(kind, points).loops);
}

/// Two conics cannot form a circle; four cubic Bezier curves nearly do.
Outline circle() {
    const double k = 0.5522847498;
    return outline(bezier_curve, {{1, 0},
                                  {1, k},
                                  {k, 1},
                                  {0, 1},
                                  {0, 1},
                                  {-k, 1},
                                  {-1, k},
                                  {-1, 0},
                                  {-1, 0},
                                  {-1, -k},
                                  {-k, -1},
                                  {0, -1},
                                  {0, -1},
                                  {k, -1},
                                  {1, -k},
                                  {1, 0}});
}

constexpr auto nowhere = [](const Rectangle&) { return false; };

}  // namespace

TEST_CASE("points are within an odd number of loops", "[shape]") {
    const Outline frame =
        outline(linear_curve,
                {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}});
    Draw draw(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 p(draw.between(-1, 5), draw.between(-1, 5));
        const double off = std::fmax(std::abs(p.x - 2), std::abs(p.y - 2));
        CHECK(frame.contains(p) == (off > 1 && off < 2));
    }
    // Heights of corners are no exception.
    for (const double y : {0.5, 1.0, 3.0}) {
        CHECK(frame.contains({0.5, y}));
        CHECK_FALSE(frame.contains({-0.5, y}));
        CHECK_FALSE(frame.contains({4.5, y}));
    }
}

TEST_CASE("points are within one of several curves, or between two of them", "[shape]") {
    // Each square has more sides than fit in a group.
    const auto square = [](std::vector<Vec2>& points, const Vec2& low, double size) {
        constexpr int parts = 10;
        const std::array corners = {low, low + Vec2(size, 0), low + Vec2(size),
                                    low + Vec2(0, size)};
        for (std::size_t side = 0; side < 4; ++side)
            for (int i = 0; i < parts; ++i)
                points.push_back(glm::mix(corners[side], corners[(side + 1) % 4], i / 10.0));
        points.push_back(low);
    };
    std::vector<Vec2> points;
    for (const auto& [x, size] : {std::pair(0.0, 2.0), {3.0, 2.0}, {3.5, 1.0}, {6.0, 2.0}})
        square(points, Vec2(x, size == 1 ? 0.5 : 0.0), size);
    const Outline squares = outline(linear_curve, points);
    const auto within = [](const Vec2& p, const Vec2& low, double size) {
        return p.x > low.x && p.x < low.x + size && p.y > low.y && p.y < low.y + size;
    };
    Draw draw(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 p(draw.between(-1, 9), draw.between(-1, 3));
        const bool ring = within(p, {3, 0}, 2) && !within(p, {3.5, 0.5}, 1);
        CAPTURE(p.x, p.y);
        CHECK(squares.contains(p) == (within(p, {0, 0}, 2) || ring || within(p, {6, 0}, 2)));
    }
}

TEST_CASE("curved outlines contain what is within them", "[shape]") {
    const Outline round = circle();
    Draw draw(2);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 p(draw.between(-1.2, 1.2), draw.between(-1.2, 1.2));
        if (std::abs(std::hypot(p.x, p.y) - 1) < 1e-3) continue;
        CHECK(round.contains(p) == (std::hypot(p.x, p.y) < 1));
    }
    for (const double x : {-0.99, 0.0, 0.99}) CHECK(round.contains({x, 0}));
    CHECK(round.bounds().low == Vec2(-1));
    CHECK(round.bounds().high == Vec2(1));
}

TEST_CASE("normals of edges point to the outside, in holes as well, for loops of any sense",
          "[shape]") {
    for (const Outline& area :
         {circle(), outline(linear_curve, {{0, 0}, {0, 4}, {4, 4}, {4, 0}, {0, 0}}),
          outline(linear_curve,
                  {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}}),
          outline(
              linear_curve,
              {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}})})
        area.for_edges(nowhere, [&](const Outline::Edge& edge) {
            for (const double u : {0.1, 0.5, 0.8}) {
                const Vec2 p = edge.piece.at(u), n = edge.normal(u);
                CHECK(std::abs(std::hypot(n.x, n.y) - 1) < 1e-14);
                CHECK(std::abs(glm::dot(n, edge.piece.slope(u))) < 1e-13);
                CHECK(area.contains(p - 1e-3 * n));
                CHECK_FALSE(area.contains(p + 1e-3 * n));
            }
        });
}

TEST_CASE("edges and places are found in outlines of many edges", "[shape]") {
    std::vector<Vec2> saw = {{0, 0}};
    for (int i = 0; i < 50; ++i) {
        saw.push_back({i + 0.5, 2});
        saw.push_back({i + 1.0, 1});
    }
    saw.push_back({50, 0});
    saw.push_back({0, 0});
    const Outline area = outline(linear_curve, saw);
    for (int i = 1; i < 50; ++i) {
        CHECK(area.contains({i + 0.5, 1.9}));
        CHECK(area.contains({i + 0.1, 0.5}));
        CHECK_FALSE(area.contains({i + 0.01, 1.9}));
    }
    CHECK_FALSE(area.contains({-0.1, 0.5}));
    CHECK_FALSE(area.contains({50.1, 0.5}));
    std::size_t all = 0, few = 0;
    area.for_edges(nowhere, [&](const Outline::Edge&) { ++all; });
    const auto left = [](const Rectangle& box) { return box.low.x >= 3; };
    area.for_edges(left, [&](const Outline::Edge&) { ++few; });
    CHECK(all == saw.size() - 1);
    CHECK(few == 7);
}

TEST_CASE("an outline without curves contains nothing", "[shape]") {
    CHECK_FALSE(Outline().contains({0, 0}));
}

}  // namespace candelabra
