// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers are POV-Ray's; more of them are in conformance/language.
#include "solid/extent.h"

#include <catch2/catch.hpp>

namespace {

const Vec3 o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

Object object(const Shape& shape) {
    Object result;
    result.form = shape;
    return result;
}

Object group(Csg csg, const std::vector<Object>& children) {
    Object result;
    Union all{{}, {}, {}, csg};
    for (const Object& each : children) all.children.push_back(make_handle<Object>(each));
    result.form = all;
    return result;
}

Object moved(Object object, const Transform& transform) {
    object.transform = make_handle<Transform>(transform);
    return object;
}

bool is(const Box& box, const Vec3& low, const Vec3& high) {
    return length(box.low - low) < 1e-4 && length(box.high - high) < 1e-4;
}

}  // namespace

TEST_CASE("extents of shapes are POV-Ray's", "[solid]") {
    CHECK(is(extent(object(Sphere{x, 2})), Vec3(-1, -2, -2), Vec3(3, 2, 2)));
    CHECK(is(extent(object(Plane{})), Vec3(-no_end), Vec3(no_end)));
    CHECK(is(extent(object(Disc{o, y, 2, 0.5})), Vec3(-2, -0.001, -2), Vec3(2, 0.001, 2)));
    CHECK(is(extent(object(Superellipsoid{})), Vec3(-1.0001), Vec3(1.0001)));
    CHECK(is(extent(object(Shared(Polygon{{o, x, x + y, y}}))), Vec3(0, 0, -0.001),
             Vec3(1, 1, 0.001)));
}

TEST_CASE("what is turned keeps the box of its box", "[solid]") {
    const Transform turn = Transform::rotation(45.0 * z).then(Transform::translation(x));
    const Object pair =
        group(Csg::together, {object(Cuboid{o, Vec3(1)}), object(Cuboid{Vec3(2), Vec3(3)})});
    CHECK(is(extent(moved(pair, turn)), Vec3(-1.1213, 0, 0), Vec3(3.1213, 4.2426, 3)));
}

TEST_CASE("intersections are bounded by what they keep and by planes", "[solid]") {
    const Object cube = object(Cuboid{Vec3(-1), Vec3(1)});
    CHECK(
        is(extent(group(Csg::difference, {cube, object(Plane{y, 0})})), Vec3(-1, 0, -1), Vec3(1)));
    CHECK(is(extent(group(Csg::difference, {cube, object(Sphere{x, 1})})), Vec3(-1), Vec3(1)));
    CHECK(is(extent(group(Csg::intersection, {cube, object(Sphere{x, 1})})), Vec3(0, -1, -1),
             Vec3(1)));
    Object turned = moved(object(Plane{y, 0}), Transform::rotation(-90.0 * z));
    CHECK(is(extent(group(Csg::intersection, {cube, turned})), Vec3(-1), Vec3(0, 1, 1)));
    turned.inverse = true;
    CHECK(is(extent(group(Csg::intersection, {cube, turned})), Vec3(0, -1, -1), Vec3(1)));
}

TEST_CASE("confines replace a box that is larger", "[solid]") {
    Object ball = object(Sphere{o, 2});
    Confines confines;
    confines.bounds = {make_handle<Object>(object(Cuboid{Vec3(-1), Vec3(1)}))};
    ball.confines = make_handle<Confines>(confines);
    CHECK(is(extent(ball), Vec3(-1), Vec3(1)));
    confines.bounds = {make_handle<Object>(object(Cuboid{Vec3(-5), Vec3(5)}))};
    ball.confines = make_handle<Confines>(confines);
    CHECK(is(extent(ball), Vec3(-2), Vec3(2)));
}

TEST_CASE("a union without shapes, or with a light, has no end", "[solid]") {
    CHECK(is(extent(group(Csg::together, {})), Vec3(-no_end), Vec3(no_end)));
    Object lit = group(Csg::together, {object(Sphere{})});
    std::get<Union>(lit.form).lights.push_back({});
    CHECK(is(extent(lit), Vec3(-no_end), Vec3(no_end)));
}
