// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers are POV-Ray's; more of them are in conformance/language.
#include "csg/shape_extent.h"
#include "csg/same_box.h"
#include "support/axes.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("boxes along an axis are turned from z to it, from the smaller end", "[extent]") {
    const Vec3 cap(1, 2, 3);
    CHECK(is(shape_extent(Cylinder{o, cap, 0.5}, nullptr), {-0.68018, -0.58107, -0.40089},
             {1.68018, 2.58107, 3.40089}));
    CHECK(is(shape_extent(Cone{o, 0.2, cap, 0.5}, nullptr), {-0.51982, -0.46036, -0.40089},
             {1.51982, 2.46036, 3.40089}));
}

TEST_CASE("a ball that is turned has the box of a ball, a longish one that of its box",
          "[extent]") {
    const Sphere ball{Vec3(1, 0, 0), 1};
    const Transform turn = Transform::rotation(Vec3(0, 0, 90)).then(Transform::scaling(Vec3(2)));
    const Transform eighth = Transform::rotation(Vec3(0, 0, 45));
    const Transform longish = Transform::scaling(Vec3(1, 1, 2)).then(eighth);
    const double half = std::sqrt(0.5);
    CHECK(is(shape_extent(ball, nullptr), Vec3(0, -1, -1), Vec3(2, 1, 1)));
    CHECK(is(shape_extent(ball, &turn), Vec3(-2, 0, -2), Vec3(2, 4, 2)));
    CHECK(
        is(shape_extent(ball, &eighth), Vec3(half - 1, half - 1, -1), Vec3(half + 1, half + 1, 1)));
    CHECK(is(shape_extent(ball, &longish), Vec3(-half, -half, -2), Vec3(3 * half, 3 * half, 2)));
}

TEST_CASE("triangles are placed before they get a box, tori afterwards", "[extent]") {
    const Transform turn = Transform::rotation(Vec3(0, 0, 45));
    const double r = std::sqrt(0.5);
    CHECK(is(shape_extent(Triangle{o, x, y}, &turn), {-r, 0, 0}, {r, r, 0}));
    CHECK(is(shape_extent(Torus{1, 0.25}, &turn), {-1.5 * r, -1.5 * r, -1.25},
             {1.5 * r, 1.5 * r, 1.25}));
}

TEST_CASE("what has cross terms, or is no ellipsoid, has no end", "[extent]") {
    CHECK(is(shape_extent(Quadric{Vec3(1, 4, 1), o, o, -1}, nullptr), {-1, -0.5, -1}, {1, 0.5, 1}));
    CHECK(shape_extent(Quadric{Vec3(1), Vec3(0.1, 0, 0), o, -1}, nullptr).size().x > 1e10);
    CHECK(shape_extent(Quadric{Vec3(1, 0, 1), o, o, -1}, nullptr).size().x > 1e10);
}

}  // namespace candelabra
