// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/line_search.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// Sign changes of a function whose slope is within these bounds.
template <class F>
std::vector<double> changes(F f, double slope, const Interval& range, double detail = 1e-3) {
    const auto at = [&](double t) { return f(t); };
    const auto within = [&](const Interval&) { return Enclosure{all_numbers, {-slope, slope}}; };
    return sign_changes({at, within}, range, detail);
}

}  // namespace

TEST_CASE("sign changes are found where they are", "[shape]") {
    const auto waves = changes([](double t) { return std::sin(t); }, 1, {1, 10});
    REQUIRE(waves.size() == 3);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(waves[i] == Approx((static_cast<double>(i) + 1) * 3.14159265358979).epsilon(1e-13));
    CHECK(changes([](double t) { return t * t - 1e-4; }, 2, {-1, 1}).size() == 2);
    CHECK(changes([](double t) { return t * t + 1e-4; }, 2, {-1, 1}).empty());
    CHECK(changes([](double t) { return t < 0.3 ? -1.0 : 1.0; }, INFINITY, {0, 1}).at(0) ==
          Approx(0.3));
    CHECK(changes([](double t) { return t < 0.3 ? -INFINITY : NAN; }, INFINITY, {0, 1}).at(0) ==
          Approx(0.3));
}

TEST_CASE("the search ends for functions that stay at 0, jump or have no value", "[shape]") {
    CHECK(changes([](double) { return 0.0; }, 1, {0, 1}, 1e-12).empty());
    CHECK(changes([](double) { return NAN; }, 1, {0, 1}, 1e-12).empty());
    const auto wild = changes([](double t) { return std::sin(1e9 * t); }, 1e9, {0.1, 1}, 1e-15);
    CHECK(wild.size() < 100'000);
}

TEST_CASE("changes are odd in number when the signs at the ends differ", "[shape]") {
    for (int i = 0; i < 50; ++i) {
        const double shift = 0.02 * i;
        const auto found =
            changes([&](double t) { return std::sin(17 * t) + std::sin(31 * t) + shift - 0.5 * t; },
                    60, {-2, 3});
        const auto below = [&](double t) {
            return std::sin(17 * t) + std::sin(31 * t) + shift - 0.5 * t <= 0;
        };
        CHECK((found.size() % 2 == 1) == (below(-2) != below(3)));
        CHECK(std::is_sorted(found.begin(), found.end()));
    }
}

TEST_CASE("a normal looks against a ray that enters, whatever the slope says", "[shape]") {
    const Vec3 forward(0, 0, 1);
    CHECK(normal_against(Vec3(0, 3, -4), forward, true) == Vec3(0, 0.6, -0.8));
    CHECK(normal_against(Vec3(0, 3, 4), forward, false) == Vec3(0, 0.6, 0.8));
    for (const Vec3& slope : {Vec3(0, 3, 4), Vec3(0, 1, 0), Vec3(0)})
        CHECK(dot(normal_against(slope, forward, true), forward) < 0);
    CHECK(length(normal_against(Vec3(0, 3, 4), forward, true)) == Approx(1));
}

}  // namespace candelabra
