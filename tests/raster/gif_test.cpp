// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/gif.h"

#include "raster/same.h"

namespace candelabra {

namespace {

using namespace std::string_literals;

/// Two by three pixels of four colours on a canvas of four by five. Every code follows a clear
/// code, so that all codes have three bits. `order` lists the rows as they are stored.
std::string small_gif(int flags, const std::string& control) {
    // Three bits each of clear, 0, clear, 1, clear, 2, clear, 3, clear, 1, clear, 2, end.
    std::string bits;
    for (const int code : {4, 0, 4, 1, 4, 2, 4, 3, 4, 1, 4, 2, 5})
        for (int i = 0; i < 3; ++i) bits += static_cast<char>('0' + (code >> i & 1));
    std::string packed;
    for (std::size_t i = 0; i < bits.size(); i += 8) {
        int byte = 0;
        for (std::size_t k = 0; k < 8 && i + k < bits.size(); ++k) byte |= (bits[i + k] - '0') << k;
        packed += static_cast<char>(byte);
    }
    const std::string head = "GIF89a\4\0\5\0\x81\0\0"s;
    const std::string table = "\0\0\0\xff\0\0\0\xff\0\x10\x20\x30"s;
    const std::string place = ",\1\0\1\0\2\0\3\0"s + static_cast<char>(flags);
    return head + table + control + place + "\2" + static_cast<char>(packed.size()) + packed +
           "\0;"s;
}

}  // namespace

TEST_CASE("GIF files are read as by the library", "[raster]") {
    check_same(file_of({37, 21, 3, uneven<std::uint8_t>(37, 21, 3), "gif", {}}));
    check_same(file_of({300, 200, 3, std::vector<std::uint8_t>(300 * 200 * 3, 9), "gif", {}}));
    check_same(file_of({160, 120, 3, uneven<std::uint8_t>(160, 120, 3), "gif", {}}));
}

TEST_CASE("a GIF file's picture has its own size, a clear colour, and another order of rows",
          "[raster]") {
    const auto read = read_gif(small_gif(0, {}), raster_limit);
    REQUIRE(read);
    CHECK(read->width == 2);
    CHECK(read->height == 3);
    CHECK(read->alpha == std::vector<float>{1, 1, 1, 1, 1, 1});
    CHECK(read->values[3 * 1] == 1);
    CHECK(read->numbers == std::vector<std::uint16_t>{0, 1, 2, 3, 1, 2});
    // Screens of other sizes, which the picture lies beside, and of none.
    for (const char screen : {'\0', '\1', '\x7f'}) {
        std::string bytes = small_gif(0, "!\xfe\3abc\0"s);
        bytes[6] = bytes[8] = screen;
        const auto other = read_gif(bytes, raster_limit);
        REQUIRE(other);
        CHECK(other->values == read->values);
    }
    const auto interlaced = read_gif(small_gif(0x40, {}), raster_limit);
    REQUIRE(interlaced);
    CHECK(interlaced->numbers == std::vector<std::uint16_t>{0, 1, 1, 2, 2, 3});
    const auto clear = read_gif(small_gif(0, "!\xf9\4\1\0\0\2\0"s), raster_limit);
    REQUIRE(clear);
    CHECK(clear->alpha == std::vector<float>{1, 1, 0, 1, 1, 0});
    // A picture of the size of its screen is as the library reads it.
    for (const int flags : {0, 0x40})
        for (const std::string& control : {""s, "!\xf9\4\1\0\0\2\0"s}) {
            std::string bytes = small_gif(flags, control);
            bytes[6] = 2;
            bytes[8] = 3;
            bytes[25 + control.size() + 1] = bytes[25 + control.size() + 3] = 0;
            check_same(bytes);
        }
}

TEST_CASE("GIF files with colours that are missing, or pixels, are read as by POV-Ray",
          "[raster]") {
    // Two colours instead of four: those that are missing are black.
    std::string few = small_gif(0, {});
    few[10] = '\x80';
    few.erase(19, 6);
    const auto read = read_gif(few, raster_limit);
    REQUIRE(read);
    CHECK(read->values[3 * 1] == 1);
    for (const std::size_t pixel : {2, 3, 5})
        for (std::size_t i = 0; i < 3; ++i) CHECK(read->values[3 * pixel + i] == 0);
    // A row more than there are codes for.
    std::string taller = small_gif(0, {});
    taller[32] = 4;
    const auto missing = read_gif(taller, raster_limit);
    REQUIRE(missing);
    CHECK(missing->numbers == std::vector<std::uint16_t>{0, 1, 2, 3, 1, 2, 0, 0});
}

TEST_CASE("a GIF file of one table tells the numbers of its colours, also of those that are alike",
          "[raster]") {
    std::string bytes = small_gif(0, {});
    // Makes the canvas as large as the picture, and colour 2 equal to colour 1.
    bytes[6] = 2;
    bytes[8] = 3;
    bytes.replace(19, 3, bytes.substr(16, 3));
    bytes[26] = bytes[28] = 0;
    CHECK(check_same(bytes).numbers == std::vector<std::uint16_t>{0, 1, 2, 3, 1, 2});
}

TEST_CASE(
    "colours of a GIF file keep their numbers beside a clear one and in a table of the picture",
    "[raster]") {
    using Entry = std::array<std::uint8_t, 4>;
    const std::string plain = small_gif(0, {}), clear = small_gif(0, "!\xf9\4\1\0\0\2\0"s);
    const auto read = read_gif(clear, raster_limit);
    REQUIRE(read);
    CHECK(read->numbers == std::vector<std::uint16_t>{0, 1, 2, 3, 1, 2});
    REQUIRE(gif_table(plain).size() == 256);
    CHECK(gif_table(plain)[2] == Entry{0, 255, 0, 255});
    CHECK(gif_table(plain)[3] == Entry{0x10, 0x20, 0x30, 255});
    CHECK(gif_table(plain)[4] == Entry{0, 0, 0, 255});
    CHECK(gif_table(clear)[2] == Entry{0, 255, 0, 0});
    CHECK(gif_table(clear)[1] == Entry{255, 0, 0, 255});
    // The same colours in the picture's own table, behind its head.
    std::string own = plain;
    const std::string colours = own.substr(13, 12);
    own.replace(13, 12, 12, '\x77');
    own[34] = '\x81';
    own.insert(35, colours);
    const auto other = read_gif(own, raster_limit);
    REQUIRE(other);
    CHECK(other->numbers == read->numbers);
    CHECK(gif_table(own)[3] == Entry{0x10, 0x20, 0x30, 255});
    CHECK(gif_table("GIF89a").empty());
}

TEST_CASE("GIF files that are damaged are left to the library", "[raster]") {
    const std::string bytes = small_gif(0, {});
    for (std::size_t length = 0; length + 3 < bytes.size(); ++length)
        CHECK(!(length >= 6 && read_gif(bytes.substr(0, length), raster_limit)));
    CHECK(!read_gif(bytes, 5));
    for (std::size_t at = 6; at < bytes.size(); ++at)
        for (int bit = 0; bit < 8; ++bit) {
            std::string other = bytes;
            other[at] = static_cast<char>(other[at] ^ 1 << bit);
            if (const auto read = read_gif(other, raster_limit))
                CHECK(read->values.size() == 3 * read->alpha.size());
        }
}

}  // namespace candelabra
