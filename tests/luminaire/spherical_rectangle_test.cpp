// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/spherical_rectangle.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct Means {
    double solid_angle = 0;
    Vec3 direction = Vec3(0);
};

/// Sums over a grid on the rectangle.
Means summed(const Vec3& from, const Vec3& corner, const Vec3& side1, const Vec3& side2) {
    constexpr int steps = 200;
    const Vec3 area = cross(side1, side2) / double{steps} / double{steps};
    Means result;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const Vec3 offset =
                corner + (i + 0.5) / steps * side1 + (j + 0.5) / steps * side2 - from;
            const double distance = length(offset);
            const double share = std::abs(dot(area, offset)) / (distance * distance * distance);
            result.solid_angle += share;
            result.direction += share * offset / distance;
        }
    result.direction /= result.solid_angle;
    return result;
}

}  // namespace

TEST_CASE("points of a rectangle are uniform in solid angle", "[luminaire]") {
    Draw draw(1);
    for (int i = 0; i < 60; ++i) {
        const Vec3 x = draw.direction();
        const auto [y, z] = perpendiculars(x);
        const Vec3 corner = draw.point(1), side1 = (0.2 + draw.number()) * x,
                   side2 = (0.2 + draw.number()) * y;
        const Vec3 from = corner + draw.between(-1, 2) * side1 + draw.between(-1, 2) * side2 +
                          (i % 2 ? 1 : -1) * std::pow(10, draw.between(-1, 0.3)) * z;
        const Means expected = summed(from, corner, side1, side2);
        const SphericalRectangle seen(from, corner, side1, side2);
        CHECK(seen.solid_angle() == Approx(expected.solid_angle).epsilon(0.01));
        constexpr int steps = 60;
        Vec3 mean(0);
        for (int a = 0; a < steps; ++a)
            for (int b = 0; b < steps; ++b) {
                const Vec3 point = seen.sample({(a + 0.5) / steps, (b + 0.5) / steps});
                const Vec3 place = point - corner;
                CHECK(std::abs(dot(place, z)) < 1e-9);
                CHECK(dot(place, x) > -1e-9);
                CHECK(dot(place, x) < length(side1) + 1e-9);
                CHECK(dot(place, y) > -1e-9);
                CHECK(dot(place, y) < length(side2) + 1e-9);
                mean += unit(point - from) / double{steps * steps};
            }
        CHECK(length(mean - expected.direction) < 0.005);
    }
}

TEST_CASE("nothing is seen of a rectangle from its own plane", "[luminaire]") {
    const SphericalRectangle seen(Vec3(2, 0.5, 0), Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    CHECK(seen.solid_angle() == 0);
}

}  // namespace candelabra
