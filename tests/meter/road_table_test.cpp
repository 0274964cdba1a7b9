// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/road_table.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace candelabra {

TEST_CASE("a coefficient of a road lies between the entries of its table", "[meter]") {
    const RoadTable road{{0, 1, 2}, {0, 90, 180}, {100, 100, 100, 400, 200, 100, 800, 300, 0}};
    const Vec3 up(0, 1, 0), sight = unit(Vec3(60, -1.5, 0));
    const auto reduced = [&](const Vec3& light) {
        const Vec3 towards = unit(light);
        return road.coefficient(up, sight, towards) * std::pow(towards.y, 3) * 1e4;
    };
    CHECK(reduced(up) == Approx(100));
    CHECK(reduced({1, 1, 0}) == Approx(400));  // the lamp is ahead of the observer
    CHECK(reduced({0, 1, 1}) == Approx(200));
    CHECK(reduced({0, 1, -1}) == Approx(200));
    CHECK(reduced({-1, 1, 0}) == Approx(100));  // behind
    CHECK(reduced({1, 1, 1}) == Approx(300 + (std::sqrt(2.0) - 1) * 250));
    CHECK(reduced({3, 2, 0}) == Approx(600));
    CHECK(reduced({2.1, 1, 0}) == 0);
    CHECK(road.coefficient(up, sight, {1, 0, 0}) == 0);
    CHECK(road.coefficient(up, sight, {0, -1, 0}) == 0);
}

TEST_CASE("what is wrong with the table of a road is named", "[meter]") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto says = [](const RoadTable& road, const std::string& expected) {
        return problem(road).find(expected) != std::string::npos;
    };
    CHECK(problem(RoadTable{{0, 1}, {0, 180}, {1, 1, 1, 1}}).empty());
    CHECK(problem(RoadTable{{0}, {0}, {1}}).empty());
    CHECK(says({{0, 1}, {}, {}}, "angles beta"));
    CHECK(says({{0, 1}, {0, 190}, {1, 1, 1, 1}}, "angles beta"));
    CHECK(says({{0, 1}, {90, 0}, {1, 1, 1, 1}}, "angles beta"));
    CHECK(says({{0, 1}, {none, 0}, {1, 1, 1, 1}}, "angles beta"));
    CHECK(says({{}, {0, 180}, {}}, "tangents"));
    CHECK(says({{1, 1}, {0, 180}, {1, 1, 1, 1}}, "tangents"));
    CHECK(says({{0, none}, {0, 180}, {1, 1, 1, 1}}, "tangents"));
    CHECK(says({{0, 1}, {0, 180}, {1, -1, 1, 1}}, "entries"));
    CHECK(says({{0, 1}, {0, 180}, {1, 1, 1, none}}, "entries"));
}

}  // namespace candelabra
