// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/obj.h"

#include "meshing/library.h"
#include "support/folder.h"
#include "support/found.h"

namespace candelabra {

TEST_CASE("a mesh in an OBJ file is read back as it was", "[modelling]") {
    Mesh mesh;
    mesh.vertices = {Vec3(9), Vec3(0.1, 2, 3), Vec3(1e-300, 1, 0), Vec3(0, -1e20, 0), Vec3(1)};
    mesh.faces = {{1, 2, 3}, {3, 2, 4}};
    CHECK(obj(mesh) == "v 0.1 2 3\nv 1e-300 1 0\nv 0 -1e+20 0\nv 1 1 1\nf 1 2 3\nf 3 2 4\n");
    const Folder folder;
    folder.put("a.obj", obj(mesh));
    Diagnostics diagnostics;
    const auto read = read_mesh_file(found(folder / "a.obj"), diagnostics, {});
    REQUIRE(read);
    CHECK(read->shape.points.size() == 4);  // the first corner has no face
    CHECK(read->shape.points[0] == Polyhedron::Point{0.1, 2, 3});
    CHECK(read->shape.faces == std::vector<Polyhedron::Face>{{0, 1, 2}, {2, 1, 3}});
}

}  // namespace candelabra
