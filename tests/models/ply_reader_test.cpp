// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/read_text.h"

#include <bit>
#include <cstdint>

namespace candelabra {

namespace {

using Faces = std::vector<Polyhedron::Face>;

std::string header(const std::string& format, const std::string& elements) {
    return "ply\nformat " + format + " 1.0\ncomment made by hand\n" + elements + "end_header\n";
}

const std::string points =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";

/// Bytes of the numbers in big-endian or little-endian order.
template <class... Stored>
std::string stored(bool high_first, Stored... numbers) {
    std::string bytes;
    const auto add = [&](auto number) {
        auto each = std::bit_cast<std::array<char, sizeof number>>(number);
        if (high_first) std::reverse(each.begin(), each.end());
        bytes.append(each.data(), each.size());
    };
    (add(numbers), ...);
    return bytes;
}

}  // namespace

TEST_CASE("points of PLY files have normals and places in pictures", "[models]") {
    const ReadText read = read_text(
        "ply", header("ascii", points +
                                   "property float nx\nproperty float ny\nproperty float nz\n"
                                   "property uchar red\nproperty float s\nproperty float t\n" +
                                   faces) +
                   "0 0 0 0 0 1 9 0 0\n1 0 0 0 1 0 9 1 0\n0 1 0 1 0 0 9 .5 1\n3 0 1 2\n");
    REQUIRE(read.wrong == "");
    CHECK(read.shape.faces == Faces{{0, 1, 2}});
    REQUIRE(read.look.normals.size() == 3);
    CHECK(read.look.normals[1] == Polyhedron::Point{0, 1, 0});
    REQUIRE(read.look.uvs.size() == 3);
    CHECK(read.look.uvs[2] == std::array{0.5, 1.0});
    CHECK(read.look.uv_faces.empty());
    CHECK(read.look.normal_faces.empty());
}

TEST_CASE("corners of faces of PLY files may have places in pictures", "[models]") {
    const ReadText read =
        read_text("ply", header("ascii", points + "property float u\nproperty float v\n" +
                                             "element face 2\n"
                                             "property list uchar int vertex_index\n"
                                             "property list uchar float texcoord\n") +
                             "0 0 0 9 9\n1 0 0 9 9\n0 1 0 9 9\n"
                             "3 0 1 2 6 0 0 1 0 .5 1\n3 2 1 0 0\n");
    REQUIRE(read.wrong == "");
    CHECK(read.look.uv_faces == Faces{{0, 1, 2}, {3, 4, 5}});
    REQUIRE(read.look.uvs.size() == 6);
    CHECK(read.look.uvs[2] == std::array{0.5, 1.0});
    CHECK(read.look.uvs[4] == std::array{0.0, 0.0});
}

TEST_CASE("numbers of PLY files are of any type and order of bytes", "[models]") {
    const std::string elements =
        "element vertex 3\nproperty short x\nproperty double y\nproperty int8 z\n"
        "element edge 1\nproperty list uint32 uint16 of\n"
        "element face 1\nproperty list ushort uint vertex_indices\n";
    for (const bool high : {false, true}) {
        using std::int16_t, std::uint16_t, std::int8_t;
        const ReadText read =
            read_text("ply", header(high ? "binary_big_endian" : "binary_little_endian", elements) +
                                 stored(high, int16_t{-300}, 0.5, int8_t{-7}, int16_t{1}, 0.0,
                                        int8_t{0}, int16_t{0}, 1.0, int8_t{0}, 2u, uint16_t{0},
                                        uint16_t{1}, uint16_t{3}, 0u, 1u, 2u));
        CHECK(read.wrong == "");
        REQUIRE(read.shape.points.size() == 3);
        CHECK(read.shape.points[0] == Polyhedron::Point{-300, 0.5, -7});
        CHECK(read.shape.faces == Faces{{0, 1, 2}});
    }
    const ReadText whole =
        read_text("ply", header("ascii",
                                "element vertex 3\nproperty int x\nproperty int y\n"
                                "property int z\n" +
                                    faces) +
                             "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    CHECK(whole.shape.points.size() == 3);
}

TEST_CASE("faults of PLY files are told", "[models]") {
    const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
    struct Case {
        std::string text, wrong;
    };
    const Case cases[] = {
        {"no mesh\n", "it is no PLY file: it does not begin with `ply`"},
        {"ply\nformat ascii 1.0\n", "it is no PLY file: its header has no end"},
        {header("secret", ""), "its format is not known"},
        {header("ascii", "element vertex many\n"), "an element of its header has no count"},
        {header("ascii", "element vertex 3\nproperty text x\n"),
         "a property of its header cannot be read"},
        {header("ascii", "property float x\n"), "a property of its header cannot be read"},
        {header("ascii", "element vertex 1\nproperty float x\n") + "0\n",
         "its points have no x, y and z"},
        {header("ascii", points + "element face 1\nproperty int x\n") + three,
         "its faces have no `vertex_indices`"},
        {header("ascii", points + faces) + "0 0 0\n1 0\n",
         "`vertex` 1 of 3 is damaged, or missing"},
        {header("ascii", points + faces) + three + "-3 0 1 2\n",
         "`face` 0 of 1 is damaged, or missing"},
        {header("ascii", points + faces) + three + "9999999 0 1 2\n",
         "`face` 0 of 1 is damaged, or missing"},
        {header("ascii", points + faces) + three + "3 0 1 1e99\n",
         "a face names a point that is not there: there are 3, counted from 0"},
        {header("ascii", points + "element rest 1000000000000\n") + three, "it has no faces"}};
    for (const Case& c : cases) {
        CAPTURE(c.text);
        CHECK(read_text("ply", c.text).wrong == c.wrong);
    }
}

}  // namespace candelabra
