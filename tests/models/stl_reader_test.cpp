// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/read_text.h"

#include <bit>
#include <cstdint>

namespace candelabra {

namespace {

/// Little-endian bytes of the word.
std::string low_word(std::uint32_t word) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> (8 * i) & 0xff);
    return bytes;
}

std::string binary_stl(const std::string& start, std::uint32_t said, int triangles, float far) {
    std::string file = start + std::string(80 - start.size(), ' ') + low_word(said);
    for (int i = 0; i < triangles; ++i) {
        file += std::string(12, '\0');
        for (const float number : {0.0F, 0.0F, 0.0F, far, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F})
            file += low_word(std::bit_cast<std::uint32_t>(number));
        file += std::string(2, '\0');
    }
    return file;
}

}  // namespace

TEST_CASE("an STL file is binary or text, and not both", "[models]") {
    const auto binary = read_text("stl", binary_stl("solid by its first word", 1, 1, 1));
    CHECK(binary.wrong == "");
    CHECK(binary.shape.points.size() == 3);
    CHECK(binary.shape.faces.size() == 1);

    // The header begins like a text file, but its content is not read.
    const auto begun = read_text(
        "stl",
        binary_stl(
            "solid\nfacet normal 0 0 1\nouter loop\nvertex 7 7 7\nvertex 8 7 7\nvertex 7 8 7\n", 1,
            1, 1));
    CHECK(begun.wrong == "");
    CHECK(begun.shape.points.size() == 3);
    CHECK(begun.shape.faces.size() == 1);

    // Read as binary, this has triangles of one kind; the text after them has others.
    const std::string text =
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nendsolid s\n";
    std::string both = binary_stl("solid of a name that is long", 9, 1, 1);
    both[79] = '\n';
    const auto mixed = read_text("stl", both + text);
    CHECK(mixed.shape.faces.size() == (mixed.wrong.empty() ? 1 : 0));
    CHECK(mixed.shape.points.size() == (mixed.wrong.empty() ? 3 : 0));
}

TEST_CASE("damaged STL files are refused", "[models]") {
    CHECK(read_text("stl", "").wrong != "");
    CHECK(read_text("stl", binary_stl("", 0xffffffff, 1, 1)).wrong != "");
    CHECK(read_text("stl", binary_stl("", 1, 1, std::nanf(""))).wrong ==
          "a point of it is not three finite numbers");
    CHECK(read_text("stl", "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n").wrong ==
          "a facet of it has not three corners");
    CHECK(read_text("stl", "solid\nfacet\nvertex 0 0 0\nvertex 1 0").wrong != "");
    CHECK(read_text("stl", "solid\nfacet\nvertex 0 0 0\n").wrong == "it ends within a facet");
    CHECK(read_text("stl", "solid\nendsolid\n").wrong == "it has no faces");
}

}  // namespace candelabra
