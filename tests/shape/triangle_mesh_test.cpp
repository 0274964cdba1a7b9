// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/triangle_mesh.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a mesh of single triangles becomes one of lists", "[shape]") {
    const Vec3 o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    TriangleMesh mesh;
    CHECK(problem(mesh) == "a `mesh` needs a triangle");
    mesh.triangles = {{o, x, y}, {o, x, 2.0 * x}};
    mesh.triangles[0].looks = {1, 1, 1};
    mesh.smooth_triangles.resize(1);
    mesh.smooth_triangles[0].normal1 = Vec3(0.5, 0, 1);
    mesh.smooth_triangles[0].uv2 = Vec2(1, 0);
    const Mesh built = as_mesh(mesh);
    CHECK(problem(built).empty());
    CHECK(built.faces.size() == 2);  // one has no area
    CHECK(built.normal_faces.size() == 1);
    CHECK(face(built, 0).smooth);
    CHECK_FALSE(face(built, 1).smooth);
    CHECK(built.looks == std::vector<Face>{{-1, -1, -1}, {1, 1, 1}});
    CHECK(built.uvs.size() == 6);
    mesh.smooth_triangles.clear();
    mesh.triangles[0].looks = {-1, -1, -1};
    CHECK(as_mesh(mesh).looks.empty());
    CHECK(as_mesh(mesh).uvs.empty());
}

}  // namespace candelabra
