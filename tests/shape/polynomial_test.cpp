// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/polynomial.h"

#include "shape/torus.h"
#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Index of the coefficient of x^i y^j z^k.
std::size_t place(int degree, int i, int j, int k) {
    std::size_t n = 0;
    for (int a = degree; a >= 0; --a)
        for (int b = degree - a; b >= 0; --b)
            for (int c = degree - a - b; c >= 0; --c, ++n)
                if (a == i && b == j && c == k) return n;
    return n;
}

struct Term {
    int i, j, k;
    double factor;
};

std::vector<double> factors(int degree, const std::vector<Term>& terms) {
    std::vector<double> result(factor_count(degree));
    for (const Term& t : terms) result[place(degree, t.i, t.j, t.k)] += t.factor;
    return result;
}

}  // namespace

TEST_CASE("factors of a polynomial stand at the places of their terms", "[shape]") {
    CHECK(factor_count(3) == 20);
    CHECK(factor_count(4) == 35);
    CHECK(factor_count(35) == 8436);
    Draw draw(5);
    for (int degree = 2; degree <= 7; ++degree)
        for (int a = 0; a <= degree; ++a)
            for (int b = 0; a + b <= degree; ++b)
                for (int c = 0; a + b + c <= degree; ++c) {
                    const Poly poly{degree, factors(degree, {{a, b, c, 1}, {0, 0, 0, -0.4}})};
                    const Vec3 p = draw.point(1.5);
                    const double value = std::pow(p.x, a) * std::pow(p.y, b) * std::pow(p.z, c);
                    CHECK(inside(build(poly), p) == (value - 0.4 <= 0));
                }
}

TEST_CASE("a quartic torus is met where the torus is", "[shape]") {
    // (x^2 + y^2 + z^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2), multiplied out.
    const double R = 1.3, r = 0.4, k = R * R - r * r;
    const auto c = factors(4, {{4, 0, 0, 1},
                               {0, 4, 0, 1},
                               {0, 0, 4, 1},
                               {2, 2, 0, 2},
                               {2, 0, 2, 2},
                               {0, 2, 2, 2},
                               {2, 0, 0, 2 * k - 4 * R * R},
                               {0, 2, 0, 2 * k},
                               {0, 0, 2, 2 * k - 4 * R * R},
                               {0, 0, 0, k * k}});
    Draw draw(6);
    std::size_t met = 0;
    for (int i = 0; i < 500; ++i) {
        const Ray ray{draw.point(2), draw.between(0.1, 10) * draw.direction()};
        const auto expected = hits(Torus{R, r}, ray), found = hits(build(Quartic{c}), ray);
        REQUIRE(found.size() == expected.size());
        met += found.size();
        for (std::size_t n = 0; n < found.size(); ++n) {
            CHECK(found[n].t == Approx(expected[n].t).margin(1e-6));
            CHECK(found[n].entering == expected[n].entering);
            CHECK(length(found[n].normal - expected[n].normal) < 1e-5);
        }
    }
    CHECK(met > 100);
}

TEST_CASE("surfaces without end are met everywhere", "[shape]") {
    const Cubic saddle{factors(3, {{3, 0, 0, 1}, {0, 1, 0, -1}})};
    CHECK(answers(build(saddle),
                  {{Vec3(2, 1e6, 0), -y}, {{1e6 - 8, -unit(Vec3(-12, 1, 0)), false}}}, 1e-9));
    CHECK(answers(build(saddle),
                  {{Vec3(-1e5, 27, 0), x}, {{1e5 + 3, unit(Vec3(27, -1, 0)), false}}}, 1e-9));
    CHECK_FALSE(finite(bounds(build(saddle))));
}

TEST_CASE("a polynomial says how many factors it needs", "[shape]") {
    CHECK(problem(Cubic{{1, 2, 3}}) == "a `cubic` needs 20 factors, and this has 3");
    CHECK(problem(Quartic{std::vector<double>(36, 1)}) ==
          "a `quartic` needs 35 factors, and this has 36");
    CHECK(problem(Poly{2, std::vector<double>(10, 1)}).empty());
    CHECK(problem(Poly{5, std::vector<double>(10, 1)}) ==
          "a `poly` needs 56 factors, and this has 10");
    std::vector<double> constant(10, 0);
    constant.back() = 1;
    CHECK(vanishes(Poly{2, constant}) == "all its factors besides the constant are 0");
}

TEST_CASE("in a range, a polynomial is crossed where the whole line crosses it", "[shape]") {
    const AlgebraicSurface tube = build(Quartic{
        factors(4, {{4, 0, 0, 1}, {0, 4, 0, 1}, {0, 0, 4, 1}, {2, 0, 0, -2}, {0, 0, 0, 0.3}})});
    Draw draw(3);
    std::size_t found = 0;
    for (int i = 0; i < 500; ++i) {
        const Ray ray{draw.point(3), unit(draw.point(1))};
        const Interval range{draw.between(-2, 1), draw.between(1, 4)};
        Crossings part;
        crossings_between(tube, ray, range, part);
        std::size_t expected = 0;
        for (const Crossing& each : hits(tube, ray)) {
            if (!range.contains(each.t)) continue;
            REQUIRE(expected < part.size());
            CHECK(part[expected].t == Approx(each.t).margin(1e-9));
            CHECK(part[expected++].entering == each.entering);
        }
        CHECK(part.size() == expected);
        found += expected;
    }
    CHECK(found > 40);
}

TEST_CASE("a polynomial written term by term is the poly of these factors", "[shape]") {
    const Polynomial by_terms{5, {{2, 1, 2, 4}, {0, 5, 0, -2}, {1, 0, 0, 3}, {0, 0, 0, -0.5}}};
    const Poly same{5, factors(5, {{2, 1, 2, 4}, {0, 5, 0, -2}, {1, 0, 0, 3}, {0, 0, 0, -0.5}})};
    CHECK(build(by_terms).factors == build(same).factors);
    // Of repeated terms the last counts.
    const Polynomial again{2, {{1, 1, 0, 7}, {0, 0, 2, 1}, {1, 1, 0, 2}}};
    CHECK(build(again).factors == factors(2, {{1, 1, 0, 2}, {0, 0, 2, 1}}));

    CHECK(problem(again).empty());
    CHECK(problem(Polynomial{2, {{1, 1, 0, 2}, {2, 0, 1, 2}}}) ==
          "xyz(2, 0, 1) is of a higher degree than the 2 of its `polynomial`");
    CHECK(vanishes(Polynomial{2, {}}) == "all its factors besides the constant are 0");
}

}  // namespace candelabra
