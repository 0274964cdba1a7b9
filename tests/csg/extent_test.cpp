// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers are POV-Ray's; more of them are in conformance/language.
#include "csg/extent.h"
#include "csg/same_box.h"
#include "support/axes.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Object lone_object(const Shape& shape) {
    Object result;
    result.form = shape;
    return result;
}

Object object_group(Csg csg, const std::vector<Object>& children) {
    Object result;
    Union all{{}, {}, {}, csg};
    for (const Object& each : children) all.children.push_back(make_handle<Object>(each));
    result.form = all;
    return result;
}

Object moved_object(Object lone_object, const Transform& transform) {
    lone_object.transform = make_handle<Transform>(transform);
    return lone_object;
}

}  // namespace

TEST_CASE("extents of shapes are POV-Ray's", "[solid]") {
    CHECK(is(extent(lone_object(Sphere{x, 2})), Vec3(-1, -2, -2), Vec3(3, 2, 2)));
    CHECK(is(extent(lone_object(Plane{})), Vec3(-no_end), Vec3(no_end)));
    CHECK(is(extent(lone_object(Disc{o, y, 2, 0.5})), Vec3(-2, -0.001, -2), Vec3(2, 0.001, 2)));
    CHECK(is(extent(lone_object(Superellipsoid{})), Vec3(-1.0001), Vec3(1.0001)));
    CHECK(is(extent(lone_object(Shared(Polygon{{o, x, x + y, y}}))), Vec3(0, 0, -0.001),
             Vec3(1, 1, 0.001)));
}

TEST_CASE("what is turned keeps the box of its box", "[solid]") {
    const Transform turn = Transform::rotation(45.0 * z).then(Transform::translation(x));
    const Object pair = object_group(
        Csg::together, {lone_object(Cuboid{o, Vec3(1)}), lone_object(Cuboid{Vec3(2), Vec3(3)})});
    CHECK(is(extent(moved_object(pair, turn)), Vec3(-1.1213, 0, 0), Vec3(3.1213, 4.2426, 3)));
}

TEST_CASE("intersections are bounded by what they keep and by planes", "[solid]") {
    const Object cube = lone_object(Cuboid{Vec3(-1), Vec3(1)});
    CHECK(is(extent(object_group(Csg::difference, {cube, lone_object(Plane{y, 0})})),
             Vec3(-1, 0, -1), Vec3(1)));
    CHECK(is(extent(object_group(Csg::difference, {cube, lone_object(Sphere{x, 1})})), Vec3(-1),
             Vec3(1)));
    CHECK(is(extent(object_group(Csg::intersection, {cube, lone_object(Sphere{x, 1})})),
             Vec3(0, -1, -1), Vec3(1)));
    Object turned = moved_object(lone_object(Plane{y, 0}), Transform::rotation(-90.0 * z));
    CHECK(is(extent(object_group(Csg::intersection, {cube, turned})), Vec3(-1), Vec3(0, 1, 1)));
    turned.inverse = true;
    CHECK(is(extent(object_group(Csg::intersection, {cube, turned})), Vec3(0, -1, -1), Vec3(1)));
}

TEST_CASE("confines replace a box that is larger", "[solid]") {
    Object ball = lone_object(Sphere{o, 2});
    Clipping clipping;
    clipping.bounds = {make_handle<Object>(lone_object(Cuboid{Vec3(-1), Vec3(1)}))};
    ball.clipping = make_handle<Clipping>(clipping);
    CHECK(is(extent(ball), Vec3(-1), Vec3(1)));
    clipping.bounds = {make_handle<Object>(lone_object(Cuboid{Vec3(-5), Vec3(5)}))};
    ball.clipping = make_handle<Clipping>(clipping);
    CHECK(is(extent(ball), Vec3(-2), Vec3(2)));
}

TEST_CASE("inverse confines have no end, as in POV-Ray", "[solid]") {
    for (const bool clips : {false, true})
        for (const Object& shape :
             {lone_object(Cuboid{Vec3(-1), Vec3(1)}), lone_object(Sphere{o, 1}),
              lone_object(Cylinder{-3.0 * y, 3.0 * y, 0.5}), lone_object(Torus{1, 0.2}),
              object_group(Csg::together, {lone_object(Sphere{o, 1})})}) {
            Object inverse = shape;
            inverse.inverse = true;
            Object ball = lone_object(Sphere{o, 2});
            Clipping clipping;
            (clips ? clipping.clips : clipping.bounds).push_back(make_handle<Object>(inverse));
            ball.clipping = make_handle<Clipping>(clipping);
            CHECK(is(extent(ball), Vec3(-2), Vec3(2)));
        }
}

TEST_CASE("a union without shapes, or with a light, has no end", "[solid]") {
    CHECK(is(extent(object_group(Csg::together, {})), Vec3(-no_end), Vec3(no_end)));
    Object lit = object_group(Csg::together, {lone_object(Sphere{})});
    std::get<Union>(lit.form).lights.push_back({});
    CHECK(is(extent(lit), Vec3(-no_end), Vec3(no_end)));
}

}  // namespace candelabra
