// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/exr_writer.h"

#include "raster/as_library.h"

#include <bit>

namespace candelabra {

namespace {

ChannelPlane some_plane(std::string name, bool whole, std::size_t pixels, std::uint32_t seed) {
    ChannelPlane plane{std::move(name), whole, {}};
    for (const float value : some_values<float>(pixels, seed))
        plane.bits.push_back(std::bit_cast<std::uint32_t>(value));
    return plane;
}

}  // namespace

TEST_CASE("OpenEXR files of pictures are those of the library", "[raster]") {
    for (const int channels : {1, 3, 4})
        for (const int height : {1, 15, 16, 17, 40}) {
            INFO(channels << " channels, " << height << " rows");
            const RawPicture picture{
                7,
                height,
                channels,
                some_values<float>(static_cast<std::size_t>(7 * height * channels)),
                "exr",
                "zip",
                height == 17 ? "made by a test" : ""};
            std::string bytes;
            REQUIRE(write_exr(picture, bytes).empty());
            CHECK((bytes == as_library(picture)));
        }
}

TEST_CASE("OpenEXR files of layers are those of the library", "[raster]") {
    LayeredPicture picture{33, 35, {}, {}};
    const std::size_t pixels = 33 * 35;
    picture.planes = {some_plane("R", false, pixels, 1), some_plane("G", false, pixels, 2),
                      some_plane("B", false, pixels, 3), some_plane("count", true, pixels, 4),
                      some_plane("a.name.of.more.than.thirty.one.letters", false, pixels, 5)};
    picture.texts = {{"candelabra.picture", "a text"}, {"empty", ""}, {"zeta", "1"}};
    std::string bytes;
    REQUIRE(write_exr(picture, bytes).empty());
    CHECK((bytes == as_library(picture)));
}

TEST_CASE("an OpenEXR file has pixels, and floats", "[raster]") {
    std::string bytes;
    CHECK_FALSE(write_exr(LayeredPicture{0, 0, {}, {}}, bytes).empty());
    CHECK_FALSE(write_exr(LayeredPicture{1, 1, {}, {}}, bytes).empty());
    CHECK_FALSE(write_exr({1, 1, 3, some_values<std::uint8_t>(3), "exr", "zip"}, bytes).empty());
}

}  // namespace candelabra
