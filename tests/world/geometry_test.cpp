// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/geometry.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <string>

namespace candelabra {

namespace {

// One item of each kind; the composite has two leaves.
const char* const one_of_each =
    "sphere { 0, 1 } triangle { 0, x, y } torus { 2, 0.5 }"
    "difference { box { -3, 3 } sphere { 0, 2 } }";

std::string kind_of_item(const Geometry& geometry, std::uint32_t item) {
    using namespace std::string_literals;
    return geometry.visit(
        item, [](const SpherePrimitive&) { return "sphere"s; },
        [](const TrianglePrimitive&) { return "triangle"s; },
        [](const PlacedShape&) { return "shape"s; },
        [](const PlacedComposite&) { return "composite"s; });
}

}  // namespace

TEST_CASE("items are numbered by kind, with composites behind all others", "[world]") {
    const SharedWorld world = world_of(one_of_each);
    const Geometry& geometry = world->geometry;
    REQUIRE(geometry.item_count() == 4);
    const std::string kinds[] = {"sphere", "triangle", "shape", "composite"};
    for (std::uint32_t item = 0; item < 4; ++item) {
        CHECK(kind_of_item(geometry, item) == kinds[item]);
        CHECK(geometry.is_triangle(item) == (item == 1));
        CHECK((geometry.shape(item) != nullptr) == (item == 2));
        CHECK((geometry.composite(item) != nullptr) == (item == 3));
    }
}

TEST_CASE("the leaves of a composite are primitives of their own", "[world]") {
    const SharedWorld world = world_of(one_of_each);
    const Geometry& geometry = world->geometry;
    for (std::uint32_t leaf = 0; leaf < 2; ++leaf) {
        const PrimitiveIndex primitive = geometry.primitive(PrimitiveKind::leaf, leaf);
        CHECK(geometry.is_leaf(primitive));
        CHECK(geometry.item_of(primitive) == 3);
        const auto none = [](const auto&) { return no_primitive; };
        CHECK(geometry.visit_primitive(
                  primitive, none, none, none,
                  [](const PlacedComposite&, std::uint32_t number) { return number; }) == leaf);
    }
    CHECK(geometry.primitive(PrimitiveKind::shape, 0) == 2);
    CHECK(geometry.item_of(2) == 2);
}

TEST_CASE("bounds of items are those of their surfaces", "[world]") {
    const SharedWorld world = world_of(one_of_each);
    const Geometry& geometry = world->geometry;
    CHECK(geometry.bounds(0).high == Vec3(1));
    CHECK(geometry.bounds(1).high == Vec3(1, 1, 0));
    CHECK(contains(geometry.bounds(2), Vec3(2.5, 0, 0)));
    CHECK(contains(geometry.bounds(3), Vec3(3)));
    CHECK(contains(geometry.inside_bounds(2), Vec3(2, 0, 0)));
}

TEST_CASE("what has no end is kept apart, planes in their own place from others", "[world]") {
    const SharedWorld world = world_of(
        "plane { y, 0 } sphere { 0, 1 } plane { x, 0 rotate 20*z } quadric { <1, 0, 1>, "
        "<0, 0, 0>, <0, 0, 0>, -1 }");
    const InfiniteItems& infinite = world->geometry.infinite;
    CHECK(infinite.all.size() == 3);
    REQUIRE(infinite.planes.size() == 1);
    CHECK(infinite.others.size() == 2);
    CHECK(infinite.planes[0].intersect({Vec3(0, 2, 0), Vec3(0, -1, 0)}) == 2);
}

}  // namespace candelabra
