// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/watertight.h"

#include <catch2/catch.hpp>

#include <utility>

namespace candelabra {

namespace {

Mesh pyramid() {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}};
    return mesh;
}

bool encloses(const Mesh& mesh) { return closure(mesh) != Closure::none; }

}  // namespace

TEST_CASE("a mesh is watertight if each edge has its two faces", "[shape]") {
    CHECK(encloses(pyramid()));
    CHECK_FALSE(encloses(Mesh()));
    Mesh open = pyramid();
    open.faces.pop_back();
    CHECK_FALSE(encloses(open));
}

TEST_CASE("corners in the same place are one, and faces without area do not count", "[shape]") {
    const Mesh whole = pyramid();
    Mesh apart;
    for (const Face& face : whole.faces) {
        const int first = static_cast<int>(apart.vertices.size());
        for (const int corner : face)
            apart.vertices.push_back(whole.vertices[static_cast<std::size_t>(corner)]);
        apart.faces.push_back({first, first + 1, first + 2});
    }
    apart.faces.push_back({0, 0, 1});
    CHECK(encloses(apart));
}

TEST_CASE("windings tell where the normals of a closed mesh point", "[shape]") {
    Mesh mesh = pyramid();
    const Closure found = closure(mesh);
    const auto [a, b, c] = face(mesh, 0).corners;
    // The first face is the bottom, z = 0.
    CHECK(found == (triangle_normal(a, b, c).z < 0 ? Closure::outwards : Closure::inwards));
    for (Face& face : mesh.faces) std::swap(face[0], face[1]);
    CHECK(closure(mesh) == turned_over(found));
    CHECK(turned_over(closure(mesh)) == found);
    std::swap(mesh.faces[2][0], mesh.faces[2][1]);
    CHECK(closure(mesh) == Closure::unoriented);
}

}  // namespace candelabra
