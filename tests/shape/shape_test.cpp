// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/shape.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a shape says what is wrong with it, whichever it is", "[shape]") {
    CHECK(problem(Shape(Sphere{})).empty());
    Mesh mesh;
    mesh.vertices = {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.faces = {{0, 1, 2}};
    CHECK(problem(Shape(Shared(mesh))).empty());
    mesh.faces = {{0, 1, 3}};
    CHECK_FALSE(problem(Shape(Shared(mesh))).empty());
}

}  // namespace candelabra
