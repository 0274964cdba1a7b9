// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/read_text.h"

namespace candelabra {

namespace {

using Faces = std::vector<Polyhedron::Face>;

/// A file with four points, two normals, three texture coordinates, and the given lines.
ReadText square(const std::string& faces) {
    return read_text("obj",
                     "# a square\no it\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv\t0 +1 0\n"
                     "vn 0 0 1\nvn 0 1e0 0\nvt 0 0\nvt .5\nvt 1 1 0\nl 1 2\ns off\n" +
                         faces);
}

}  // namespace

TEST_CASE("corners of OBJ files name points, normals and places in pictures", "[models]") {
    const ReadText all = square("f 1/1/1 2/2/1 3/3/2 4/3/2\n");
    REQUIRE(all.wrong == "");
    CHECK(all.shape.points[3] == Polyhedron::Point{0, 1, 0});
    CHECK(all.shape.faces == Faces{{0, 1, 2}, {0, 2, 3}});
    CHECK(all.look.uv_faces == Faces{{0, 1, 2}, {0, 2, 2}});
    CHECK(all.look.normal_faces == Faces{{0, 0, 1}, {0, 1, 1}});
    CHECK(all.look.uvs[1] == std::array{0.5, 0.0});
    CHECK(all.look.normals[1] == Polyhedron::Point{0, 1, 0});
}

TEST_CASE("an OBJ file's lines end in any way, go on, and count backwards", "[models]") {
    const ReadText backwards = square("f -4//-2 -3//-2 \\\r\n -2//-1\r\n");
    REQUIRE(backwards.wrong == "");
    CHECK(backwards.shape.faces == Faces{{0, 1, 2}});
    CHECK(backwards.look.normal_faces == Faces{{0, 0, 1}});
    CHECK(backwards.look.uvs.empty());
    CHECK(square("f 1 2 3").shape.faces == Faces{{0, 1, 2}});
}

TEST_CASE("corners that name no normal get one without length", "[models]") {
    const ReadText mixed = square("f 1//1 2//1 3//1\nf 1 3 4\n");
    REQUIRE(mixed.wrong == "");
    CHECK(mixed.look.normal_faces == Faces{{0, 0, 0}, {2, 2, 2}});
    CHECK(mixed.look.normals.at(2) == Polyhedron::Point{0, 0, 0});
    CHECK(mixed.look.uv_faces.empty());
}

TEST_CASE("faults of OBJ files are told with their line", "[models]") {
    const std::string corner =
        "line 14: a corner of a face is `1`, `1/2`, `1//3` or `1/2/3`, and counts from 1";
    CHECK(square("f 1 2 x\n").wrong == corner);
    CHECK(square("f 0 1 2\n").wrong == corner);
    CHECK(square("f 1/-9 2/1 3/1\n").wrong == corner);
    CHECK(square("f 1 2\n").wrong == "line 14: a face has at least three corners");
    CHECK(square("v 1 2\n").wrong == "line 14: a point has three numbers");
    CHECK(square("vn 1 2\n").wrong == "line 14: a normal has three numbers");
    CHECK(square("vt u\n").wrong == "line 14: `vt` has one to three numbers");
    CHECK(square("f 1 2 9\n").wrong ==
          "a face names a point 8 that is not there: there are 4, counted from 0");
    CHECK(square("f -9 2 3\n").wrong ==
          "a face names a point that is not there: there are 4, counted from 0");
    CHECK(square("f 1/1 2/1 3/7\n").wrong ==
          "a face names a `vt` 6 that is not there: there are 3, counted from 0");
}

}  // namespace candelabra
