// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/model_file.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("meshes are read from files, larger faces in parts", "[models]") {
    struct Case {
        const char *extension, *text;
        std::size_t points, faces;
    };
    const Case cases[] = {
        {"obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", 4, 2},
        {"off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, 1},
        {"ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
         3, 1},
        {"stl",
         "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
         "endloop\nendfacet\nendsolid s\n",
         3, 1}};
    for (const Case& c : cases) {
        CAPTURE(c.extension);
        const std::string name = std::string("a.") + c.extension;
        Polyhedron made;
        PolyhedronLook look;
        REQUIRE(read_model(name, c.text, made, look) == "");
        CHECK(look.normals.empty());
        CHECK(look.uvs.empty());
        CHECK(made.points.size() == c.points);
        CHECK(made.faces.size() == c.faces);
    }
}

TEST_CASE("what is no mesh is said", "[models]") {
    Polyhedron made;
    PolyhedronLook look;
    CHECK(read_model("nothing.ply", "", made, look) != "");
    CHECK(read_model("text.off", "no mesh", made, look) ==
          "it is no OBJ, PLY, STL or OFF file, or is damaged");
    const std::string_view wild = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n";
    CHECK(read_model("wild.off", wild, made, look) != "");
    CHECK(read_model("NONE.OBJ", "v 0 0 0\n", made, look) == "it has no faces");
}

}  // namespace candelabra
