// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/tga_writer.h"

#include <catch2/catch.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

namespace {

using namespace std::literals;

RawPicture picture_of(int width, int height, int channels, std::vector<std::uint8_t> values,
                      std::string_view compression = "none", std::string description = "") {
    return {width, height, channels, std::move(values), "tga", compression, std::move(description)};
}

std::string written(const RawPicture& picture) {
    std::string bytes;
    REQUIRE(write_tga(picture, bytes) == "");
    return bytes;
}

constexpr std::size_t head = 18, tail = 495 + 26;

std::string pixels_of(const std::string& bytes) {
    return bytes.substr(head, bytes.size() - head - tail);
}

}  // namespace

TEST_CASE("Targa has blue before red and the lowest row first", "[raster]") {
    const std::string bytes = written(picture_of(1, 2, 3, {1, 2, 3, 4, 5, 6}));
    CHECK(bytes.substr(0, head) == "\0\0\2\0\0\0\0\0\0\0\0\0\1\0\2\0\x18\0"s);
    CHECK(pixels_of(bytes) == "\6\5\4\3\2\1");
    CHECK(bytes.ends_with("TRUEVISION-XFILE.\0"sv));
}

TEST_CASE("Targa has alpha and greys", "[raster]") {
    const std::string colours = written(picture_of(1, 1, 4, {1, 2, 3, 4}));
    CHECK(colours.substr(2, 1) == "\2");
    CHECK(colours.substr(16, 2) == "\x20\x08");
    CHECK(pixels_of(colours) == "\3\2\1\4");
    CHECK(colours[colours.size() - 27] == '\3');
    const std::string greys = written(picture_of(2, 1, 1, {7, 8}));
    CHECK(greys.substr(2, 1) == "\3");
    CHECK(greys.substr(16, 2) == "\x08\0"s);
    CHECK(pixels_of(greys) == "\7\10");
    CHECK(greys[greys.size() - 27] == '\0');
}

TEST_CASE("Targa's packets hold at most 128 pixels of one row", "[raster]") {
    const auto packed = [](int width, int height, std::vector<std::uint8_t> values) {
        return pixels_of(written(picture_of(width, height, 1, std::move(values), "rle")));
    };
    CHECK(packed(6, 1, {1, 2, 2, 2, 3, 4}) == "\0\1\x82\2\1\3\4"s);
    CHECK(packed(2, 2, {5, 5, 5, 5}) == "\x81\5\x81\5");
    CHECK(packed(1, 1, {9}) == "\0\t"s);
    CHECK(packed(130, 1, std::vector<std::uint8_t>(130, 6)) == "\xFF\6\x81\6");
    std::vector<std::uint8_t> stripes;
    for (int i = 0; i < 130; ++i) stripes.push_back(static_cast<std::uint8_t>(i % 2));
    CHECK(packed(130, 1, stripes).size() == 132);
}

TEST_CASE("Targa's comment has four lines", "[raster]") {
    const std::string description = std::string(80, 'a') + std::string(300, 'b');
    const std::string bytes = written(picture_of(1, 1, 1, {0}, "none", description));
    const std::string comment = bytes.substr(head + 1 + 43, 324);
    CHECK(comment.substr(0, 82) == std::string(80, 'a') + "\0b"s);
    CHECK(comment.ends_with("bbb\0"sv));
}

TEST_CASE("what Targa cannot have is refused", "[raster]") {
    std::string bytes;
    CHECK(write_tga(picture_of(0, 0, 3, {}), bytes) == "it has no pixels");
    CHECK(write_tga(picture_of(65536, 1, 1, std::vector<std::uint8_t>(65536)), bytes) ==
          "a Targa file has at most 65535 pixels along each side");
    CHECK(write_tga({1, 1, 1, std::vector<float>{1}, "tga", "none", ""}, bytes) ==
          "it has bytes only");
}

}  // namespace candelabra
