// SPDX-License-Identifier: GPL-3.0-or-later
#include "csg/assemble.h"

#include "support/axes.h"
#include "support/objects.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Object combined(Csg csg, std::vector<ObjectHandle> children) {
    return *group(csg, std::move(children));
}

Composite assembled(const Object& object) {
    ShapeStore shapes;
    return composite_of(object, shapes);
}

std::string insides(const Object& object, const std::vector<Vec3>& points) {
    const Composite composite = assembled(object);
    std::string result;
    for (const Vec3& p : points) result += composite.inside(p) ? '1' : '0';
    return result;
}

struct Visits {
    std::string said;

    void enter(const Object&) { said += '('; }
    void leave() { said += ')'; }
    void leaf(const Object& object) {
        said += std::to_string(std::get<Shape>(object.form).index());
    }
};

}  // namespace

TEST_CASE("objects combine as their words say", "[solid]") {
    const ObjectHandle left = object(Sphere{o, 1}), right = object(Sphere{x, 1});
    const std::vector<Vec3> points = {-0.5 * x, 0.5 * x, 1.5 * x, 3.0 * x};
    CHECK(insides(combined(Csg::together, {left, right}), points) == "1110");
    CHECK(insides(combined(Csg::merge, {left, right}), points) == "1110");
    CHECK(insides(combined(Csg::intersection, {left, right}), points) == "0100");
    CHECK(insides(combined(Csg::difference, {left, right}), points) == "1000");
}

TEST_CASE("inverse turns combinations round, as De Morgan says", "[solid]") {
    const ObjectHandle left = object(Sphere{o, 1}), right = object(Sphere{x, 1});
    const std::vector<Vec3> points = {-0.5 * x, 0.5 * x, 1.5 * x, 3.0 * x};
    for (const Csg csg : {Csg::together, Csg::merge, Csg::intersection, Csg::difference}) {
        Object whole = combined(csg, {left, right});
        std::string expected = insides(whole, points);
        for (char& c : expected) c = c == '0' ? '1' : '0';
        whole.inverse = true;
        CHECK(insides(whole, points) == expected);
        // Once more, within another group.
        Object outer = combined(Csg::together, {make_handle<Object>(whole)});
        outer.inverse = true;
        CHECK(insides(outer, points) == insides(combined(csg, {left, right}), points));
    }
    CHECK(insides(combined(Csg::difference, {left, object(Sphere{x, 1}, true)}), points) == "0100");
}

TEST_CASE("what has no inside stays so when it is inverse", "[solid]") {
    const ObjectHandle ball = object(Sphere{o, 1}), face = object(Triangle{-x, x, y});
    CHECK(has_inside(Shape(Sphere{o, 1})));
    CHECK_FALSE(has_inside(Shape(Triangle{-x, x, y})));
    Mesh mesh;
    CHECK_FALSE(has_inside(Shape(mesh)));
    mesh.inside_vector = o;
    CHECK_FALSE(has_inside(Shape(mesh)));
    mesh.inside_vector = x;
    CHECK(has_inside(Shape(mesh)));
    CHECK(insides(*object(Triangle{-x, x, y}, true), {o, 2.0 * x}) == "00");
    CHECK(insides(combined(Csg::difference, {ball, face}), {o, 2.0 * x}) == "00");
}

TEST_CASE("maps of groups and objects add up", "[solid]") {
    Object moved = *object(Sphere{o, 1});
    moved.transform = make_handle<Transform>(Transform::translation(x));
    Object whole = combined(Csg::intersection, {make_handle<Object>(moved)});
    whole.transform = make_handle<Transform>(Transform::rotation(90.0 * z));
    CHECK(insides(whole, {o, 0.5 * y, 1.5 * y, x}) == "0110");
}

TEST_CASE("what clips or bounds an object is in the space around it", "[solid]") {
    Object half = *object(Sphere{o, 2});
    half.transform = make_handle<Transform>(Transform::translation(5.0 * x));
    Clipping clipping;
    clipping.clips = {object(Plane{x, 5})};
    half.clipping = make_handle<Clipping>(clipping);
    CHECK(insides(half, {4.0 * x, 6.0 * x, o}) == "100");
    // `inverse` does not invert the clipping.
    half.inverse = true;
    CHECK(insides(half, {4.0 * x, 6.0 * x, o}) == "001");

    clipping = {};
    clipping.bounds = {object(Cuboid{Vec3(4, -1, -1), Vec3(6, 1, 1)})};
    half.clipping = make_handle<Clipping>(clipping);
    half.inverse = false;
    const Composite bounded = assembled(half);
    const auto any = [](std::uint32_t) { return true; };
    CHECK_FALSE(bounded.first({Vec3(6.5, 0, -5), z}, Interval{}, any));
    CHECK(bounded.first({Vec3(5.5, 0, -5), z}, Interval{}, any));
    CHECK(bounded.inside(Vec3(6.5, 0, 0)));
}

TEST_CASE("visitors hear of every object and of each leaf in its order", "[solid]") {
    const Object whole = combined(
        Csg::difference,
        {object(Sphere{o, 1}),
         make_handle<Object>(combined(Csg::together, {object(Cuboid{}), object(Plane{})}))});
    CompositeBuilder builder;
    ShapeStore shapes;
    Visits visits;
    const PartRef root = Assembler<Visits>(builder, shapes, visits).add(whole, {});
    CHECK(visits.said == "((0)((1)(2)))");
    const Composite composite = builder.finish(root);
    REQUIRE(composite.leaf_count() == 3);
    CHECK_FALSE(composite.leaf(0).inverse);
    CHECK(composite.leaf(1).inverse);
    CHECK(composite.leaf(2).inverse);
}

TEST_CASE("light sources in a group are no part of the solid", "[solid]") {
    Object light = combined(Csg::together, {});
    std::get<Union>(light.form).lights.push_back({});
    const Object whole =
        combined(Csg::intersection, {make_handle<Object>(light), object(Sphere{o, 1})});
    CHECK(insides(whole, {o, 2.0 * x}) == "10");
    CHECK(assembled(combined(Csg::together, {})).bounds().empty());
}

}  // namespace candelabra
