// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflection_density.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// Points of a level square, `per_unit` to a unit of length.
void add_square(std::vector<Vec3>& to, const Vec3& corner, double size, double per_unit) {
    const int across = static_cast<int>(size * per_unit);
    for (int x = 0; x < across; ++x)
        for (int z = 0; z < across; ++z)
            to.push_back(corner + Vec3((x + 0.5) / per_unit, 0, (z + 0.5) / per_unit));
}

}  // namespace

TEST_CASE("the density of reflections is known from place to place", "[transport]") {
    std::vector<Vec3> positions;
    add_square(positions, Vec3(0), 8, 4);
    add_square(positions, Vec3(20, 0, 0), 8, 1);
    const ReflectionDensity density(positions);
    for (const double at : {1.3, 4.2, 6.7}) {
        CHECK(density.at({at, 0, 4}) == Approx(16).epsilon(0.6));
        CHECK(density.at({20 + at, 0, 4}) == Approx(1).epsilon(0.6));
    }
}

TEST_CASE("the density of reflections is finite and above 0 anywhere", "[transport]") {
    const std::vector<Vec3> alike(100, Vec3(1, 2, 3));
    std::vector<Vec3> line;
    for (int i = 0; i < 100; ++i) line.emplace_back(i, 0, 0);
    for (const std::vector<Vec3>& positions : {alike, line, {Vec3(0), Vec3(1)}}) {
        const ReflectionDensity density(positions);
        for (const Vec3& place : {Vec3(1, 2, 3), Vec3(-1e9, 5, 1e9), Vec3(50, 0, 0)}) {
            CHECK(density.at(place) > 0);
            CHECK(std::isfinite(density.at(place)));
        }
    }
}

}  // namespace candelabra
