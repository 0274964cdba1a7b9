// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/spline.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

using Kind = Spline::Kind;

Spline spline(const std::vector<std::array<double, 3>>& points, Kind kind) {
    std::vector<Spline::Knot> knots;
    for (const auto& [t, x, y] : points) Spline::insert(knots, {t, {x, y}});
    return Spline(std::move(knots), 2, kind);
}

void check(const Spline& spline, double t, double x, double y) {
    INFO(t);
    CHECK(spline.at(t)[0] == Approx(x).margin(1e-12));
    CHECK(spline.at(t)[1] == Approx(y).margin(1e-12));
    CHECK(spline.at(t)[2] == 0);
}

const std::vector<std::array<double, 3>> growing = {{0, 0, 0}, {1, 1, 1}, {2, 4, 8}, {3, 9, 27}};

}  // namespace

TEST_CASE("splines give POV-Ray's values", "[base]") {
    SECTION("linear") {
        const Spline s = spline(growing, Kind::linear);
        check(s, -1, 0, 0);
        check(s, 1.5, 2.5, 4.5);
        check(s, 9, 9, 27);
    }
    SECTION("quadratic") {
        const Spline s = spline(growing, Kind::quadratic);
        check(s, -1, 0, 0);
        check(s, 0.5, 0.25, -0.25);
        check(s, 1.5, 2.25, 3.75);
        check(s, 2.5, 6.25, 16);
        check(s, 4, 9, 27);
    }
    SECTION("natural") {
        const Spline s = spline(growing, Kind::natural);
        check(s, -1, 0, 0);
        check(s, 0.5, 0.35, 0.2);
        check(s, 1.5, 2.2, 3.15);
        check(s, 2.5, 6.35, 16.45);
        check(s, 4, 9, 27);
    }
    SECTION("cubic") {
        const Spline s =
            spline({{-1, 0, 0}, {0, 0, 1}, {1, 1, 1}, {2, 4, 8}, {3, 9, 27}}, Kind::cubic);
        check(s, -2, 0, 1);
        check(s, -0.5, 0, 1);
        check(s, 0.5, 0.3125, 0.625);
        check(s, 1.5, 2.25, 3.3125);
        check(s, 2.5, 4, 8);
        check(s, 4, 4, 8);
        const Spline uneven = spline({{0, 0, 0}, {1, 1, 3}, {4, 2, 1}, {5, 7, 7}}, Kind::cubic);
        CHECK(uneven.at(2)[0] == Approx(0.96296).epsilon(1e-4));
        CHECK(uneven.at(3.5)[1] == Approx(0.30324).epsilon(1e-4));
    }
}

TEST_CASE("a spline of few points is what is possible", "[base]") {
    for (const Kind kind : {Kind::linear, Kind::quadratic, Kind::cubic, Kind::natural})
        check(spline({{0, 7, 8}}, kind), 0.5, 7, 8);
    for (const Kind kind : {Kind::linear, Kind::quadratic, Kind::natural})
        check(spline({{0, 0, 0}, {1, 1, 2}}, kind), 0.25, 0.25, 0.5);
    check(spline({{0, 0, 0}, {1, 1, 2}}, Kind::cubic), 0.25, 0.5, 1);
    check(spline({{0, 0, 0}, {1, 1, 1}, {2, 5, 5}}, Kind::cubic), 1.5, 1, 1);
}

TEST_CASE("a spline passes through its points and knows no gaps", "[base]") {
    for (const Kind kind : {Kind::linear, Kind::quadratic, Kind::natural}) {
        const Spline s = spline(growing, kind);
        for (const auto& [t, x, y] : growing) {
            check(s, t, x, y);
            CHECK(s.at(t + 1e-9)[1] == Approx(y).margin(1e-6));
        }
    }
}

TEST_CASE("knots are put in order", "[base]") {
    check(spline({{2, 4, 4}, {0, 0, 0}, {1, 1, 1}}, Kind::linear), 1.5, 2.5, 2.5);
    // A knot replaces another one at the same place, but not the last.
    check(spline({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1, 5, 5}}, Kind::linear), 1, 5, 5);
    check(spline({{0, 0, 0}, {1, 1, 1}, {1, 3, 3}}, Kind::linear), 1, 1, 1);
}

TEST_CASE("what is not a number is answered with the beginning", "[base]") {
    for (const Kind kind : {Kind::linear, Kind::quadratic, Kind::cubic, Kind::natural}) {
        const Spline s = spline(growing, kind);
        CHECK(s.at(std::nan(""))[0] == s.at(-1e300)[0]);
    }
}

}  // namespace candelabra
