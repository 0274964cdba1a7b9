// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/lists.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("mesh2 reads its lists", "[reading]") {
    const Script done =
        run("#version 3.7; mesh2 { vertex_vectors { 3, 0, x, <0, 1> } normal_vectors { 1, z } "
            "face_indices { 1, <0, 1, 2> } normal_indices { 1, <0, 0, 0> } inside_vector y }");
    REQUIRE(done.text.empty());
    const Mesh& mesh = *done.shape<Shared<Mesh>>();
    CHECK(mesh.vertices == std::vector<Vec3>{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
    CHECK(mesh.normals == std::vector<Vec3>{Vec3(0, 0, 1)});
    CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}});
    CHECK(mesh.normal_faces == std::vector<Face>{{0, 0, 0}});
    CHECK(mesh.inside_vector == Vec3(0, 1, 0));
}

TEST_CASE("faces may have textures and places in a picture", "[reading]") {
    const Script done =
        run("#version 3.7; mesh2 { vertex_vectors { 3, 0, x, y } uv_vectors { 2, <0, 0>, <1, 0> } "
            "texture_list { 2, texture { pigment { rgb 1 } } texture { pigment { rgb x } } } "
            "face_indices { 3, <0, 1, 2>, <0, 2, 1>, 1, <0, 1, 2>, 0, 1, 1 } "
            "uv_indices { 3, <0, 0, 1>, <0, 1, 1>, <0, 0, 0> } }");
    REQUIRE(done.text.empty());
    const Mesh& mesh = *done.shape<Shared<Mesh>>();
    CHECK(mesh.uvs == std::vector<Vec2>{Vec2(0, 0), Vec2(1, 0)});
    CHECK(mesh.uv_faces.at(1) == Face{0, 1, 1});
    CHECK(mesh.looks == std::vector<Face>{{-1, -1, -1}, {1, 1, 1}, {0, 1, 1}});
    CHECK(done.scene.objects[0]->part_textures->list.size() == 2);
}

TEST_CASE("lists may be written by loops", "[reading]") {
    const Script done =
        run("#version 3.7; mesh2 { vertex_vectors { 5, #for (I, 0, 3) <I, I*I, 0> #end z } "
            "face_indices { 2, <0, 1, 4> <1, 2, 4> } }");
    REQUIRE(done.text.empty());
    CHECK(done.shape<Shared<Mesh>>()->vertices[3] == Vec3(3, 9, 0));
}

TEST_CASE("plain vectors and others may follow each other in a list", "[reading]") {
    const Script done =
        run("#version 3.7; mesh2 { vertex_vectors { 6, <0, 0, 0>, <-1, .5, 2>, 2*x, <0, 1, 0>, <1, "
            "2>, 7 } face_indices { 3 <0, 1, 2>, <1, 2, 3> <1, 1 + 1, 3> } }");
    REQUIRE(done.text.empty());
    const Mesh& mesh = *done.shape<Shared<Mesh>>();
    CHECK(mesh.vertices == std::vector<Vec3>{Vec3(0), Vec3(-1, .5, 2), Vec3(2, 0, 0), Vec3(0, 1, 0),
                                             Vec3(1, 2, 0), Vec3(7)});
    CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}, {1, 2, 3}, {1, 2, 3}});
}

TEST_CASE("wrong lists are told of once", "[reading]") {
    const std::string head = "mesh2 { vertex_vectors { 3, 0, x, y } ";
    CHECK(complaint("mesh2 { vertex_vectors { 2, 0, x, y } face_indices { 1, <0, 1, 2> } }") ==
          "error wrong-count: `vertex_vectors` has 3 entries, but its count is 2");
    CHECK(complaint("mesh2 { vertex_vectors { } }") ==
          "error missing: `vertex_vectors` needs a count");
    CHECK(complaint("mesh2 { vertex_vectors 3 }")
              .rfind("error wrong-type: `vertex_vectors` of `mesh2` must be a list", 0) == 0);
    CHECK(complaint(head + "face_indices { 1, <0, 1, 2.5> } }") ==
          "warning no-effect: an entry of `face_indices` is three whole numbers; what is behind "
          "their points does not count");
    CHECK(complaint(head + "face_indices { 2, <0, 1, 2>, <0, 1, 3000000000> } }") ==
          "error bad-index: an entry of `face_indices` is beyond all indices");
    CHECK(complaint(head + "face_indices { 2, <0, 1, 2> } }") ==
          "error wrong-count: `face_indices` has 1 entry, but its count is 2");
    CHECK(complaint(head + "face_indices { 1, <0, 1, 2>, 0 } }") ==
          "error bad-index: a face has texture 0, but there are 0 in `texture_list`, counted from "
          "0");
    CHECK(complaint(head + "face_indices { 1, <0, 1, 2>, 0, 1, 2, 3 } }") ==
          "error wrong-count: a face in `face_indices` has one texture, or three for its corners");
    CHECK(complaint(head + "uv_vectors { 2, <0, 0>, <1, 1> } face_indices { 1, <0, 1, 2> } }") ==
          "error degenerate: a `mesh2` with 2 uv vectors for 3 vertices needs `uv_indices`");
    CHECK(complaint(head + "face_indices { 1, \"a\" } }") ==
          "error wrong-type: an entry of `face_indices` must be a vector of 3, but it is a string");
    CHECK(complaint(head + "face_indices { 1, <0, 1, 3> } }").rfind("error degenerate: ", 0) == 0);
}

}  // namespace candelabra
