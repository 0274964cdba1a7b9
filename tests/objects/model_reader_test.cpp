// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/model_reader.h"

#include "support/folder.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const Mesh& mesh_of(const Script& done) { return *done.shape<Shared<Mesh>>(); }

double volume(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [a, b, c] = face(mesh, i).corners;
        sum += dot(a, cross(b, c)) / 6;
    }
    return sum;
}

Script made(const std::string& block) {
    Script done = run("#version 3.7;\n" + block);
    INFO(done.text);
    REQUIRE(done.said.empty());
    return done;
}

/// Runs `mesh { file "t.obj" words }` with this text as the file, which is not on the disk: a mesh
/// is made of the loader's text without opening the file again.
Script made_of_file(const std::string& text, const std::string& words = "") {
    return run("#version 3.7; mesh { file \"t.obj\" " + words + " }", {{"t.obj", text}});
}

}  // namespace

TEST_CASE("objects become meshes", "[objects]") {
    const Script cut =
        made("mesh { difference { box { 0, 2 } box { 1, 3 } } texture { pigment { rgb x } } }");
    CHECK(volume(mesh_of(cut)) == Approx(7));
    CHECK(mesh_of(cut).inside_vector);
    CHECK(mesh_of(cut).normals.empty());
    const Script ball = made("mesh { sphere { 0, 1 } resolution 16 smooth scale 2 }");
    CHECK(mesh_of(ball).normals.size() == mesh_of(ball).vertices.size());
    CHECK(ball.object().transform);
    // The mesh takes the texture of the object.
    const Script named = made(
        "#declare B = blob { threshold 0.5 sphere { 0, 1, 1 } pigment { rgb <0, 1, 0> } }\n"
        "mesh { object { B } resolution 12 }");
    CHECK(named.texture().pigment.colour.rgb == Rgb(0, 1, 0));
}

TEST_CASE("hulls are made of points and objects", "[objects]") {
    CHECK(volume(mesh_of(made("mesh { convex_hull { 0, x, y, z } }"))) == Approx(1.0 / 6));
    CHECK(volume(mesh_of(made("mesh { convex_hull { box { 0, 1 } box { 2, 3 } } }"))) == Approx(7));
    const Script mixed =
        made("#declare B = box { 0, 1 }\nmesh { convex_hull { B <0.5, 2, 0.5> } subdivide 1 }");
    CHECK(mesh_of(mixed).faces.size() > 24);
}

TEST_CASE("triangles are refined and smoothed", "[objects]") {
    const std::string pyramid =
        "triangle { x, y, z } triangle { 0, y, x } triangle { 0, z, y } triangle { 0, x, z }";
    CHECK(mesh_of(made("mesh { " + pyramid + " }")).faces.size() == 4);
    CHECK(mesh_of(made("mesh { " + pyramid + " subdivide 2 smooth }")).faces.size() == 64);
}

TEST_CASE("files are read where scenes may read", "[objects]") {
    const Folder folder;
    folder.put("t.off",
               "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n"
               "3 1 2 3\n");
    const std::string file = folder / "t.off";
    const Script done =
        run("#version 3.7; mesh { file \"" + file + "\" }", {{file, folder.get("t.off")}});
    CHECK(done.text.empty());
    CHECK(mesh_of(done).faces.size() == 4);
    CHECK_FALSE(mesh_of(done).inside_vector);
    CHECK(complaint("mesh { file \"none.ply\" }").ends_with("there is no file `none.ply`"));
}

TEST_CASE("normals and uv of files are kept as far as the shape is", "[objects]") {
    const auto read = [](const std::string& words) {
        return made_of_file(
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 0 1 0\n"
            "f 1/1/1 2/2/1 3/3/2\n",
            words);
    };
    const Script plain = read("");
    CHECK(plain.text.empty());
    CHECK(face(mesh_of(plain), 0).normals[2] == Vec3(0, 1, 0));
    CHECK(face_uvs(mesh_of(plain), 0)[1] == Vec2(1, 0));
    const Script smooth = read("smooth");
    // The normals of the file are replaced by that of the face.
    CHECK(mesh_of(smooth).normals == std::vector(3, Vec3(0, 0, 1)));
    CHECK(face_uvs(mesh_of(smooth), 0)[1] == Vec2(1, 0));
    const Script finer = read("subdivide 1");
    CHECK(mesh_of(finer).faces.size() == 4);
    CHECK(mesh_of(finer).normals.empty());
    CHECK(mesh_of(finer).uvs.empty());
}

TEST_CASE("materials of a file are told of once, for they are left out", "[objects]") {
    const Script done = made_of_file(
        "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n"
        "usemtl blue\nf 1 3 2\n");
    REQUIRE(done.said.size() == 1);
    CHECK(done.said[0].severity == Severity::warning);
    CHECK(done.said[0].fault == Fault::no_effect);
    CHECK(done.said[0].message == "the materials of this file are left out");
    CHECK(mesh_of(done).faces.size() == 2);
}

TEST_CASE("what does not become a mesh is told", "[objects]") {
    const std::string head = "error degenerate: this does not become a mesh: ";
    CHECK(complaint("mesh { plane { y, 0 } }") == head + "it has no end");
    CHECK(complaint("mesh { union { box { 0, 1 } plane { y, 0 } } }") == head + "it has no end");
    CHECK(complaint("mesh { convex_hull { 0, x, y } }") == head + "the points lie in one plane");
    CHECK(complaint("mesh { polygon { 4, 0, x, y, 0 } }") ==
          head + "its `polygon` is no solid, has no end, or is too thin for the `resolution`");
    CHECK(complaint("mesh { box { 0, 1 } box { 0, 1 } }") ==
          "error misplaced: a `mesh` is made of one object or hull, and this is a second");
    CHECK(complaint("mesh { triangle { 0, x, y } box { 0, 1 } }") ==
          "error misplaced: a `mesh` is made of triangles, a file, an object or a hull, not of "
          "several of these");
    CHECK(complaint("mesh { sphere { 0, 1 } resolution 2 }").starts_with("error out-of-range"));
    CHECK(complaint("mesh { sphere { 0, 1 } subdivide 8 }").starts_with("error out-of-range"));
    CHECK(complaint("mesh { }") == "error degenerate: a `mesh` needs a triangle");
    CHECK(complaint("mesh { convex_hull { \"a\" } }").starts_with("error wrong-type"));
}

}  // namespace candelabra
