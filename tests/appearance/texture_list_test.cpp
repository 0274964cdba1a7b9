// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/texture_list.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("triangles of a mesh have a texture, or three", "[appearance]") {
    const Script done = run(R"(#version 3.7;
        #declare Red = texture { pigment { rgb x } }
        mesh {
            triangle { 0, x, y texture { Red } }
            triangle { 0, y, z texture_list { Red, Red, texture { pigment { rgb z } } } }
            smooth_triangle { 0, z, x, z, y, z uv_vectors <0, 0>, <1, 0>, <0, 1> }
            inside_vector y
        })");
    REQUIRE(done.text.empty());
    const Mesh& mesh = *done.shape<Shared<Mesh>>();
    CHECK(mesh.looks == std::vector<Face>{{-1, -1, -1}, {0, 0, 0}, {0, 0, 1}});
    CHECK(mesh.uvs.at(1) == Vec2(1, 0));
    CHECK(mesh.inside_vector == Vec3(0, 1, 0));
    CHECK(done.scene.objects[0]->part_textures->list.size() == 2);
}

TEST_CASE("a list of textures has as many as it says", "[appearance]") {
    const std::string triangle = "mesh { triangle { 0, x, y texture_list { ";
    CHECK(complaint(triangle + "texture { pigment { rgb 1 } } } } }") ==
          "error wrong-count: `texture_list` has 1 texture, but it needs 3");
    CHECK(complaint("mesh2 { vertex_vectors { 3, 0, x, y } texture_list { } }") ==
          "error wrong-count: `texture_list` needs a count");
}

}  // namespace candelabra
