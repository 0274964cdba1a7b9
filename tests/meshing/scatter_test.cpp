// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/scatter.h"

#include "shape/mesh_area.h"
#include "shape/tessellation.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Composite alone(const BuiltShape& shape) {
    CompositeBuilder builder;
    const PartRef leaf = builder.add({shape});
    return builder.finish(leaf);
}

}  // namespace

TEST_CASE("scattered points keep their distance and leave no gap", "[modelling]") {
    const Composite ball = alone(Sphere{Vec3(1, 2, 3), 2});
    const Mesh triangles = seen_tessellation(ball, 32);
    constexpr double distance = 0.5;
    const auto points = scattered(ball, triangles, distance, 1);
    const double squares = MeshArea(triangles).total() / (distance * distance);
    CHECK(points.size() > 0.58 * squares);
    CHECK(points.size() < 0.9 * squares);
    double nearest = 1e9;
    for (const SurfacePoint& p : points) {
        CHECK(length(p.position - Vec3(1, 2, 3)) == Approx(2).epsilon(1e-9));
        CHECK(dot(p.normal, unit(p.position - Vec3(1, 2, 3))) == Approx(1));
        for (const SurfacePoint& other : points)
            if (&other != &p) nearest = std::min(nearest, length(p.position - other.position));
    }
    CHECK(nearest >= distance);
    // Each corner of a triangle has a point near it.
    for (const Vec3& v : triangles.vertices)
        CHECK(std::ranges::any_of(points, [&](const SurfacePoint& p) {
            return length(p.position - v) < 1.2 * distance;
        }));
}

TEST_CASE("the seed chooses the points", "[modelling]") {
    const Composite ring = alone(Torus{2, 0.5});
    const Mesh triangles = seen_tessellation(ring, 16);
    const auto first = scattered(ring, triangles, 0.4, 1),
               again = scattered(ring, triangles, 0.4, 1),
               other = scattered(ring, triangles, 0.4, 2);
    REQUIRE(first.size() == again.size());
    CHECK(first.front().position == again.front().position);
    CHECK(first.front().position != other.front().position);
}

TEST_CASE("points lie where the surface is seen", "[modelling]") {
    CompositeBuilder builder;
    const PartRef ball = builder.add({Sphere{Vec3(0), 1}}),
                  half = builder.add({Plane{Vec3(0, 1, 0), 0}});
    const Composite bowl = builder.finish(builder.add(Combination::common, {ball, half}));
    for (const SurfacePoint& p : scattered(bowl, seen_tessellation(bowl, 32), 0.2, 1))
        CHECK(p.position.y < 1e-9);
}

}  // namespace candelabra
