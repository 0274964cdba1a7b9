// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/curve.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

double distance(const Vec2& a, const Vec2& b) { return glm::length(a - b); }

const std::vector<Vec2> five = {{0.5, -1}, {1, 0}, {0.5, 1}, {1, 2}, {0.2, 3}};

}  // namespace

TEST_CASE("curves go through the points that their kind says", "[shape]") {
    const auto linear = curve(linear_curve, five);
    REQUIRE(linear.size() == 4);
    CHECK(linear[2].at(0.5) == Vec2(0.75, 1.5));
    const auto quadratic = curve(quadratic_curve, five);
    REQUIRE(quadratic.size() == 3);
    CHECK(quadratic[0].at(0) == five[1]);
    CHECK(distance(quadratic[0].at(1), five[2]) < 1e-15);
    CHECK(distance(quadratic[0].at(0.5), {0.875, 0.5}) < 1e-15);
    const auto cubic = curve(cubic_curve, five);
    REQUIRE(cubic.size() == 2);
    CHECK(cubic[1].at(0) == five[2]);
    CHECK(distance(cubic[1].at(1), five[3]) < 1e-15);
    CHECK(distance(cubic[0].at(0.5), {0.75, 0.5}) < 1e-15);
    const std::vector<Vec2> four = {{1, 0}, {2, 0.5}, {0.5, 1}, {1, 2}};
    const auto bezier = curve(bezier_curve, four);
    REQUIRE(bezier.size() == 1);
    CHECK(distance(bezier[0].at(1), {1, 2}) < 1e-15);
    CHECK(distance(bezier[0].at(0.5), (four[0] + 3.0 * four[1] + 3.0 * four[2] + four[3]) / 8.0) <
          1e-15);
    const CurvePiece conic = conic_piece({0, 0}, {1, 2}, {2, 0});
    CHECK(distance(conic.at(0.5), {1, 1}) < 1e-15);
}

TEST_CASE("pieces are joined smoothly", "[shape]") {
    for (const CurveKind kind : {quadratic_curve, cubic_curve}) {
        const auto pieces = curve(kind, five);
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
            CHECK(distance(pieces[i].at(1), pieces[i + 1].at(0)) < 1e-15);
            if (kind == cubic_curve)
                CHECK(distance(pieces[i].slope(1), pieces[i + 1].slope(0)) < 1e-14);
        }
    }
}

TEST_CASE("bounds of a piece hold its turns", "[shape]") {
    const CurvePiece arch = conic_piece({0, 0}, {1, 2}, {2, 0});
    CHECK(bounds(arch).low == Vec2(0, 0));
    CHECK(bounds(arch).high == Vec2(2, 1));
    const Rectangle both = join(bounds(arch), bounds(line_piece({5, 5}, {4, -6})));
    CHECK(both.low == Vec2(0, -6));
    CHECK(both.high == Vec2(5, 5));
}

TEST_CASE("loops end where they come back to their start", "[shape]") {
    const std::vector<Vec2> two = {{0, 0}, {4, 0}, {4, 4}, {0, 0}, {1, 1}, {3, 1}, {3, 3}, {1, 1}};
    const Loops linear = closed_curves(linear_curve, two);
    CHECK(linear.closed);
    REQUIRE(linear.loops.size() == 2);
    CHECK(linear.loops[1].size() == 3);
    CHECK(linear.loops[1][0].start == Vec2(1, 1));

    const Loops left_open = closed_curves(linear_curve, std::span(two).first(3));
    CHECK(left_open.closed);
    REQUIRE(left_open.loops.size() == 1);
    CHECK(left_open.loops[0].back().end == Vec2(0, 0));

    const std::vector<Vec2> ring = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}};
    for (const CurveKind kind : {quadratic_curve, cubic_curve}) {
        const std::size_t length = kind == quadratic_curve ? 6 : 7;
        std::vector<Vec2> twice(ring.begin(), ring.begin() + static_cast<long>(length));
        twice.insert(twice.end(), ring.begin(), ring.begin() + static_cast<long>(length));
        const Loops loops = closed_curves(kind, twice);
        CHECK(loops.closed);
        REQUIRE(loops.loops.size() == 2);
        CHECK(loops.loops[0].size() == 4);
        CHECK(loops.loops[1].size() == 4);
        CHECK_FALSE(closed_curves(kind, std::span(ring).first(5)).closed);
    }
    const std::vector<Vec2> bezier = {{1, 0},  {1, 1},   {-1, 1}, {-1, 0},
                                      {-1, 0}, {-1, -1}, {1, -1}, {1, 0}};
    CHECK(closed_curves(bezier_curve, bezier).closed);
    CHECK(closed_curves(bezier_curve, bezier).loops.size() == 1);
    CHECK_FALSE(closed_curves(bezier_curve, std::span(bezier).first(4)).closed);
}

}  // namespace candelabra
