// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers are POV-Ray's; more of them are in conformance/language.
#include "csg/traced_normal.h"
#include "csg/solid.h"
#include "support/axes.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Vec3 traced(const Shape& shape, const Vec3& from, const Vec3& direction, bool inverse = false) {
    Object object;
    object.form = shape;
    object.inverse = inverse;
    return Solids().trace(make_handle<Object>(object), from, direction)->normal;
}

Shape prism(const std::vector<Vec2>& points) {
    Prism result;
    result.points = points;
    return Shared(result);
}

}  // namespace

TEST_CASE("normals of prisms are on the right of their curves", "[solid]") {
    const Vec2 a(0, 0), b(1, 0), c(1, 1);
    CHECK(traced(prism({a, b, c, a}), Vec3(5, 0.5, 0.3), -x).x > 0);
    CHECK(traced(prism({a, c, b, a}), Vec3(5, 0.5, 0.3), -x).x < 0);
    CHECK(traced(prism({a, b, c, a}), Vec3(0.7, -5, 0.3), y).y > 0);
}

TEST_CASE("normals of inverse quadrics are those of the quadrics", "[solid]") {
    CHECK(traced(Quadric{}, -5.0 * z, z, true).z < 0);
    CHECK(traced(Sphere{}, -5.0 * z, z, true).z > 0);
}

}  // namespace candelabra
