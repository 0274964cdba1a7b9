// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/face_normal.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("faces have their own normals on the side of those for shading", "[shape]") {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}};
    for (const double side : {-1.0, 1.0}) {
        mesh.normals = {{0, 0, side}, {0.9, 0, side}, {0, 0.9, side}};
        const BuiltShape shape = built(Shape(Shared<Mesh>(mesh)));
        CHECK(face_normal(shape, 0) == Vec3(0, 0, side));
        CompositeLeaf leaf{shape};
        const Composite::Meeting met{1, unit(mesh.normals[1]), 0, 0};
        CHECK(surface_normal(leaf, met) == Vec3(0, 0, side));
        leaf.inverse = true;
        CHECK(surface_normal(leaf, met) == Vec3(0, 0, -side));
    }
    CHECK(face_normal(Sphere{}, 0) == Vec3(0));
    CHECK(surface_normal({Sphere{}}, {1, Vec3(0, 0, 2), 0, 0}) == Vec3(0, 0, 1));
}

}  // namespace candelabra
