// SPDX-License-Identifier: GPL-3.0-or-later
#include "csg/solid.h"

#include "support/axes.h"
#include "support/objects.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {}  // namespace

TEST_CASE("rays are traced with directions of any length", "[solid]") {
    Solids solids;
    const ObjectHandle ball = object(Sphere{o, 1});
    const auto hit = solids.trace(ball, -5.0 * z, 9.0 * z);
    REQUIRE(hit);
    CHECK(hit->position == -z);
    CHECK(hit->normal == -z);
    CHECK_FALSE(solids.trace(ball, Vec3(5), x));
    // Hits nearer than 1e-4 are on the surface that the ray starts from.
    CHECK(solids.trace(ball, -z, z)->position == z);
    CHECK_FALSE(solids.trace(ball, z, z));
}

TEST_CASE("several objects can be asked in turn", "[solid]") {
    Solids solids;
    const ObjectHandle ball = object(Sphere{o, 1}), cube = object(Cuboid{o, Vec3(3)});
    for (int i = 0; i < 3; ++i) {
        CHECK(solids.inside(ball, -0.5 * x));
        CHECK_FALSE(solids.inside(cube, -0.5 * x));
        CHECK(solids.inside(cube, Vec3(2)));
        CHECK_FALSE(solids.inside(ball, Vec3(2)));
    }
    const ObjectHandle cut = group(Csg::difference, {cube, ball});
    CHECK_FALSE(solids.inside(cut, Vec3(0.1)));
    CHECK(solids.inside(cut, Vec3(1)));
}

TEST_CASE("surfaces have no inside, nor has what holds one", "[solid]") {
    CHECK(has_inside(*object(Sphere{})));
    CHECK(has_inside(*object(Disc{})));
    CHECK_FALSE(has_inside(*object(Shared(Triangle{}))));
    CHECK_FALSE(has_inside(*object(Shared(Mesh{}))));
    CHECK_FALSE(has_inside(*group(Csg::together, {object(Sphere{}), object(Shared(Polygon{}))})));
}

}  // namespace candelabra
