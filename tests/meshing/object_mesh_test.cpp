// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/object_mesh.h"

#include "cgal/shapes.h"
#include "support/axes.h"
#include "support/objects.h"

#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Volume of the object's mesh.
double volume_of(const ObjectHandle& what, int cells = 32) {
    const SolidMesh made = solid_mesh(*what, cells, &the_polyhedra());
    INFO(made.problem);
    CHECK(made.problem.empty());
    return made.problem.empty() ? volume(made.polyhedron) : 0;
}
std::string problem_of(const ObjectHandle& what) {
    return solid_mesh(*what, 16, &the_polyhedra()).problem;
}

}  // namespace

TEST_CASE("boolean operations on boxes are exact", "[modelling]") {
    const ObjectHandle a = object(Cuboid{o, Vec3(2)}), b = object(Cuboid{Vec3(1), Vec3(3)});
    CHECK(volume_of(group(Csg::together, {a, b})) == Approx(15).epsilon(1e-14));
    CHECK(volume_of(group(Csg::merge, {a, b})) == Approx(15).epsilon(1e-14));
    CHECK(volume_of(group(Csg::intersection, {a, b})) == Approx(1).epsilon(1e-14));
    CHECK(volume_of(group(Csg::difference, {a, b})) == Approx(7).epsilon(1e-14));
    CHECK(volume_of(group(Csg::intersection, {a, object(Cuboid{Vec3(1), Vec3(3)}, true)})) ==
          Approx(7).epsilon(1e-14));
}

TEST_CASE("half spaces cut", "[modelling]") {
    const ObjectHandle ball = object(Sphere{o, 1}), below = object(Plane{y, 0});
    CHECK(volume_of(group(Csg::intersection, {ball, below}), 48) ==
          Approx(2 * pi / 3).epsilon(0.01));
    CHECK(volume_of(group(Csg::difference, {ball, below}), 48) == Approx(2 * pi / 3).epsilon(0.01));
    const ObjectHandle far = transformed(object(Plane{y, 0}), Transform::translation(-10.0 * y));
    CHECK(problem_of(group(Csg::intersection, {ball, far})) == "nothing is left");
}

TEST_CASE("parts are turned, stretched and mirrored as they are placed", "[modelling]") {
    const ObjectHandle box = object(Cuboid{o, Vec3(1)});
    CHECK(volume_of(transformed(box, Transform::scaling({-2, 1, 3}))) == Approx(6));
    const ObjectHandle two =
        group(Csg::together,
              {box, transformed(object(Cuboid{o, Vec3(1)}), Transform::translation(5.0 * x))});
    CHECK(volume_of(transformed(two, Transform::scaling(Vec3(2)))) == Approx(16));
}

TEST_CASE("what is no closed solid says so", "[modelling]") {
    const ObjectHandle box = object(Cuboid{o, Vec3(1)});
    CHECK(problem_of(object(Plane{y, 0})) == "it has no end");
    CHECK(problem_of(object(Sphere{o, 1}, true)) == "it has no end");
    CHECK(problem_of(group(Csg::together, {box, object(Plane{y, 0})})) == "it has no end");
    CHECK(problem_of(group(Csg::together, {})) == "there is nothing in it");
    const ObjectHandle sheet = object(Shared(Triangle{o, x, y}));
    CHECK(problem_of(group(Csg::difference, {box, sheet})) ==
          "surface 2 bounds no solid: it is not closed");
    ObjectHandle clipped = object(Sphere{o, 1});
    clipped.edit().clipping = make_handle<Clipping>(Clipping{{box}, {}});
    CHECK(problem_of(clipped) == "`clipped_by` leaves it open; use `intersection`");
}

TEST_CASE("surfaces are exact where they can be, and seen triangles elsewhere", "[modelling]") {
    const ObjectHandle a = object(Cuboid{o, Vec3(2)}), b = object(Cuboid{Vec3(1), Vec3(3)});
    const Mesh exact = surface_mesh(group(Csg::difference, {a, b}), 16, &the_polyhedra());
    CHECK(volume(polyhedron(exact)) == Approx(7));
    // The surfaces of a union pass through each other, as rays see them.
    CHECK(surface_mesh(group(Csg::together, {a, b}), 16, &the_polyhedra()).faces.size() == 24);
    ObjectHandle opened = a;
    opened.edit().clipping = make_handle<Clipping>(Clipping{{object(Plane{y, 9})}, {}});
    CHECK(surface_mesh(opened, 16, &the_polyhedra()).faces.size() == 12);
    CHECK(surface_mesh(object(Plane{y, 0}), 16, &the_polyhedra()).faces.empty());
}

}  // namespace candelabra
