// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/roots.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

#include <complex>

namespace candelabra {

namespace {

std::vector<double> multiplied(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> product(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
    return product;
}

/// The polynomial with these roots, times others without real roots.
std::vector<double> with_roots(const std::vector<double>& roots, int pairs, Draw& draw) {
    std::vector<double> c = {draw.number() < 0.5 ? 3.0 : -0.2};
    for (const double root : roots) c = multiplied(c, {-root, 1});
    for (int i = 0; i < pairs; ++i) {
        const double real = draw.between(-2, 2), imaginary = draw.between(0.3, 2);
        c = multiplied(c, {real * real + imaginary * imaginary, -2 * real, 1});
    }
    return c;
}

/// Roots far enough apart that rounding in the coefficients moves none of them much.
std::vector<double> drawn_roots(std::size_t count, double low, double high, Draw& draw) {
    std::vector<double> roots;
    const double step = (high - low) / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i)
        roots.push_back(low + step * (static_cast<double>(i) + draw.between(0.2, 0.8)));
    return roots;
}

std::vector<double> found(const std::vector<double>& c, const Interval& range) {
    const Roots roots = sign_changes(c, range);
    return {roots.begin(), roots.end()};
}

}  // namespace

TEST_CASE("the roots of random polynomials are found where they are", "[base]") {
    Draw draw(1);
    for (std::size_t count = 1; count <= 8; ++count)
        for (int pairs = 0; pairs <= 2; ++pairs)
            for (int i = 0; i < 100; ++i) {
                const auto roots = drawn_roots(count, -3, 3, draw);
                const auto c = with_roots(roots, pairs, draw);
                for (const Interval& range : {whole_line, Interval{-10, 10}, Interval{-1e7, 1e6}}) {
                    const auto at = found(c, range);
                    INFO(count << " roots, " << pairs << " pairs");
                    REQUIRE(at.size() == count);
                    for (std::size_t k = 0; k < count; ++k)
                        CHECK(std::abs(at[k] - roots[k]) < 1e-6);
                }
            }
}

TEST_CASE("only roots in the range count", "[base]") {
    Draw draw(2);
    for (int i = 0; i < 300; ++i) {
        const auto roots = drawn_roots(5, -4, 4, draw);
        const auto c = with_roots(roots, 1, draw);
        const double a = draw.between(-5, 5), b = draw.between(-5, 5);
        for (const Interval& range :
             {Interval{std::fmin(a, b), std::fmax(a, b)}, Interval{a, infinity},
              Interval{-infinity, b}, Interval{5, 1}}) {
            const auto expected = std::count_if(roots.begin(), roots.end(),
                                                [&](double r) { return range.contains(r); });
            CHECK(found(c, range).size() == static_cast<std::size_t>(expected));
        }
    }
}

TEST_CASE("roots of any size are found", "[base]") {
    for (const double scale : {1e-9, 1e-3, 1.0, 1e4, 1e9}) {
        std::vector<double> c = {1};
        for (const double root : {-2.0, -1.0, 0.5, 7.0}) c = multiplied(c, {-root * scale, 1});
        const auto at = found(c, whole_line);
        REQUIRE(at.size() == 4);
        CHECK(at[0] == Approx(-2 * scale));
        CHECK(at[1] == Approx(-scale));
        CHECK(at[2] == Approx(0.5 * scale));
        CHECK(at[3] == Approx(7 * scale));
    }
}

TEST_CASE("roots that change no sign do not count", "[base]") {
    CHECK(found(multiplied({1, -2, 1}, {4, 0, 1}), whole_line).empty());
    const auto one = found(multiplied({1, -2, 1}, {-3, 1}), whole_line);
    REQUIRE(one.size() == 1);
    CHECK(one[0] == Approx(3));
    CHECK(found({-8, 12, -6, 1}, whole_line).size() == 1);
    CHECK(found({-8, 12, -6, 1}, whole_line)[0] == Approx(2).margin(1e-4));
    CHECK(found({1, 0, 1}, whole_line).empty());
    CHECK(found({1, 2, 1}, whole_line).empty());
}

TEST_CASE("roots at round numbers are found once", "[base]") {
    for (const double at : {-2.0, -1.0, 0.0, 1.0, 2.0})
        for (const std::vector<double>& rest :
             {std::vector<double>{5, 0, 1}, {-5, 0, -1}, {5, 0, 6, 0, 1}, {1, 1, 1}}) {
            const auto only = found(multiplied({-at, 1}, rest), whole_line);
            INFO(at);
            REQUIRE(only.size() == 1);
            CHECK(only[0] == Approx(at).margin(1e-15));
        }
}

TEST_CASE("zeros, infinities and what is no number give no roots", "[base]") {
    CHECK(found({}, whole_line).empty());
    CHECK(found({0}, whole_line).empty());
    CHECK(found({3}, whole_line).empty());
    CHECK(found({0, 0, 0, 0, 0}, whole_line).empty());
    CHECK(found({-6, 2, 0, 0, 0}, whole_line) == std::vector<double>{3});
    CHECK(found({-4, 0, 1, 0}, whole_line) == std::vector<double>{-2, 2});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(found({nan, 1, 2, 3, nan}, whole_line).size() <= 4);
    CHECK(found({infinity, 1, 2, 3, 4}, {-1, 1}).size() <= 4);
}

TEST_CASE("all roots of the highest degrees are found", "[base]") {
    // Chebyshev polynomials have all their roots between -1 and 1, and stay small between them.
    std::vector<double> before = {1}, last = {0, 1};
    for (std::size_t degree = 2; degree <= greatest_degree; ++degree) {
        std::vector<double> next = multiplied({0, 2}, last);
        for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
        before = std::exchange(last, next);
        if (degree > 20 && degree < greatest_degree) continue;
        const auto at = found(last, {-1.001, 1.001});
        INFO(degree);
        CHECK(at.size() == degree);
        for (const double root : at) {
            const double turn = std::acos(root) * static_cast<double>(degree) / 3.14159265358979;
            CHECK(std::abs(turn - std::floor(turn) - 0.5) < 1e-2);
        }
    }
}

TEST_CASE("known signs at the ends decide whether the number of roots is odd", "[base]") {
    const std::vector<double> line = {-1, 1};
    CHECK(sign_changes(line, {0, 1}, -1, 0).size() == 1);
    CHECK(sign_changes(line, {0, 1}, -1, 0)[0] == 1);
    CHECK(sign_changes(line, {1, 2}, 0, 1).empty());
    CHECK(sign_changes(line, {1, 2}, -1e-20, 1).size() == 1);
    CHECK(sign_changes(line, {1, 2}, -1e-20, 1)[0] == 1);
    const std::vector<double> hill = {-0.001, 1, -1};  // roots near 0 and 1
    CHECK(sign_changes(hill, {0, 1}, -1, -1).size() == 2);
    CHECK(sign_changes(hill, {0, 0.5}, 1, 1).empty());
    const Roots late = sign_changes(hill, {0, 1}, 1, -1);
    REQUIRE(late.size() == 3);
    CHECK(late[2] == 1);
}

}  // namespace candelabra
