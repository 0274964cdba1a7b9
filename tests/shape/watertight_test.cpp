// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/watertight.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Mesh pyramid() {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}};
    return mesh;
}

}  // namespace

TEST_CASE("a mesh is watertight if each edge has its two faces", "[shape]") {
    CHECK(is_watertight(pyramid()));
    CHECK_FALSE(is_watertight(Mesh()));
    Mesh open = pyramid();
    open.faces.pop_back();
    CHECK_FALSE(is_watertight(open));
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
    CHECK(is_watertight(apart));
}

}  // namespace candelabra
