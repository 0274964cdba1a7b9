// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/tga.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using namespace std::string_literals;

/// Returns the header of a 2 x 2 file: image type, size and bits of the colour table, bits per
/// pixel, descriptor.
std::string head(int kind, int colours, int table_bits, int bits, int descriptor) {
    const auto byte = [](int value) { return std::string(1, static_cast<char>(value)); };
    return "\0"s + byte(colours > 0 ? 1 : 0) + byte(kind) + "\0\0"s + byte(colours) + "\0"s +
           byte(table_bits) + "\0\0\0\0\2\0\2\0"s + byte(bits) + byte(descriptor);
}

/// Returns the red of every pixel as a byte.
std::vector<int> reds(const StoredPicture& picture) {
    std::vector<int> result;
    for (std::size_t i = 0; i < picture.values.size(); i += 3)
        result.push_back(static_cast<int>(255 * picture.values[i] + 0.5F));
    return result;
}

}  // namespace

TEST_CASE("Targa files of numbers have a table", "[picture]") {
    const std::string bytes = head(1, 3, 24, 8, 0x20) + "\1\2\3\4\5\6\7\x8\x9"s + "\0\1\2\1"s;
    const auto table = tga_table(bytes);
    REQUIRE(table.size() == 3);
    CHECK(table[1] == std::array<std::uint8_t, 4>{6, 5, 4, 255});
    StoredPicture picture;
    REQUIRE(read_tga(bytes, 4, picture));
    CHECK(picture.numbers == std::vector<std::uint16_t>{0, 1, 2, 1});
    CHECK(reds(picture) == std::vector{3, 6, 9, 6});
}

TEST_CASE("rows of Targa files may begin anywhere, and be packed", "[picture]") {
    const std::string table = "\0\0\1\0\0\2\0\0\3\0\0\4"s;
    for (const auto& [descriptor, expected] :
         {std::pair{0x20, std::vector{1, 2, 3, 3}}, {0, {3, 3, 1, 2}}, {0x30, {2, 1, 3, 3}}}) {
        CAPTURE(descriptor);
        StoredPicture plain, packed;
        REQUIRE(read_tga(head(1, 4, 24, 8, descriptor) + table + "\0\1\2\2"s, 4, plain));
        REQUIRE(read_tga(head(9, 4, 24, 8, descriptor) + table + "\1\0\1\x81\2"s, 4, packed));
        CHECK(reds(plain) == expected);
        CHECK(reds(packed) == expected);
    }
}

TEST_CASE("the sixteenth bit of a colour says that it is opaque", "[picture]") {
    const std::string pixels = "\xff\x7f\xff\xff\0\x84\0\0"s;
    StoredPicture picture;
    REQUIRE(read_tga(head(2, 0, 0, 16, 0x20) + pixels, 4, picture));
    CHECK(reds(picture) == std::vector{248, 248, 8, 0});
    CHECK(picture.alpha == std::vector<float>{0, 1, 1, 0});
    CHECK(picture.numbers.empty());
}

TEST_CASE("other Targa files, and damaged ones, are left to others", "[picture]") {
    StoredPicture picture;
    CHECK_FALSE(read_tga(head(2, 0, 0, 24, 0x20) + std::string(12, 'a'), 4, picture));
    CHECK_FALSE(read_tga(head(2, 0, 0, 16, 0x20) + "abc", 4, picture));
    CHECK_FALSE(read_tga(head(2, 0, 0, 16, 0x20) + std::string(8, 'a'), 3, picture));
    CHECK_FALSE(read_tga(head(1, 1, 24, 8, 0x20) + "abc" + "\0\0\0\1"s, 4, picture));
    CHECK_FALSE(read_tga(head(1, 200, 24, 8, 0x20) + "abc", 4, picture));
    CHECK_FALSE(read_tga("", 4, picture));
    CHECK(is_tga("a/b.tga"));
    CHECK_FALSE(is_tga("a.png"));
}

TEST_CASE("a Targa file that is damaged leaves the picture as it was", "[picture]") {
    StoredPicture picture;
    const std::string bytes = head(1, 1, 24, 8, 0x20) + "abc" + "\0\0\0\1"s;
    CHECK(reads_tga(bytes));
    CHECK_FALSE(read_tga(bytes, 4, picture));
    CHECK(picture.width == 0);
    CHECK(picture.values.empty());
    CHECK(picture.numbers.empty());
    // Run-length packets hold at most 128 times as many pixels as the file has bytes.
    std::string wide = head(9, 1, 24, 8, 0x20) + "abc" + "\xff\0"s;
    wide[13] = wide[15] = '\x3f';
    CHECK_FALSE(read_tga(wide, 1 << 28, picture));
}

}  // namespace candelabra
