// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/used_corners.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("corners that no face has are left out, and the others come as faces ask",
          "[modelling]") {
    Mesh mesh;
    mesh.vertices = {Vec3(0), Vec3(1), Vec3(2), Vec3(3), Vec3(4)};
    mesh.faces = {{3, 1, 2}, {2, 1, 0}};
    const Mesh used = with_used_corners(mesh);
    CHECK(used.vertices == std::vector{Vec3(3), Vec3(1), Vec3(2), Vec3(0)});
    CHECK(used.faces == std::vector<Face>{{0, 1, 2}, {2, 1, 3}});
    CHECK(with_used_corners(Mesh()).vertices.empty());
}

}  // namespace candelabra
