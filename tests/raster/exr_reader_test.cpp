// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/exr_reader.h"

#include "raster/as_library.h"
#include "raster/exr_writer.h"

#include <bit>
#include <cmath>

namespace candelabra {

namespace {

constexpr std::int64_t enough_pixels = 1 << 20;

LayeredPicture some_layers() {
    LayeredPicture picture{9, 37, {}, {}};
    for (const char* name : {"A", "B", "G", "R", "times"}) {
        ChannelPlane plane{name, name == std::string("times"), {}};
        for (const float value : some_values<float>(9 * 37, static_cast<std::uint32_t>(name[0])))
            plane.bits.push_back(std::bit_cast<std::uint32_t>(value));
        picture.planes.push_back(std::move(plane));
    }
    picture.texts = {{"first", "a text"}, {"second", "another"}};
    return picture;
}

std::string written(const LayeredPicture& picture) {
    std::string bytes;
    REQUIRE(write_exr(picture, bytes).empty());
    return bytes;
}

}  // namespace

TEST_CASE("an OpenEXR file is read as it was written", "[raster]") {
    const LayeredPicture picture = some_layers();
    LayeredPicture read;
    read.texts = {{"second", ""}, {"third", ""}};
    const std::string bytes = written(picture);
    REQUIRE(reads_exr(bytes));
    CHECK(read_exr(bytes, enough_pixels, read).empty());
    CHECK(read.width == 9);
    CHECK(read.height == 37);
    REQUIRE(read.planes.size() == picture.planes.size());
    for (std::size_t i = 0; i < read.planes.size(); ++i) {
        CHECK(read.planes[i].name == picture.planes[i].name);
        CHECK(read.planes[i].whole == picture.planes[i].whole);
        CHECK(read.planes[i].bits == picture.planes[i].bits);
    }
    CHECK(read.texts[0].second == "another");
    CHECK(read.texts[1].second.empty());
}

TEST_CASE("colours are read as the library reads them", "[raster]") {
    Diagnostics diagnostics;
    const Formats* const formats = picture_formats(diagnostics);
    REQUIRE(formats != nullptr);
    for (const int channels : {1, 3, 4}) {
        const std::string bytes = as_library(
            RawPicture{5, 20, channels,
                       some_values<float>(static_cast<std::size_t>(100 * channels)), "exr", "zip"});
        StoredPicture own, other;
        REQUIRE(reads_exr(bytes));
        CHECK(read_exr(bytes, enough_pixels, own).empty());
        CHECK(formats->read(bytes, enough_pixels, other).empty());
        CHECK(own.width == other.width);
        CHECK(own.channels == other.channels);
        CHECK(own.values == other.values);
        CHECK(own.alpha == other.alpha);
        CHECK(own.bits == other.bits);
        CHECK(own.linear == other.linear);
        CHECK(own.format == other.format);
    }
}

TEST_CASE("no damage of an OpenEXR file does harm", "[raster]") {
    const std::string bytes = written(some_layers());
    for (std::size_t length = 0; length < bytes.size(); length += 7) {
        LayeredPicture read;
        const std::string part = bytes.substr(0, length);
        CHECK_FALSE((reads_exr(part) && read_exr(part, enough_pixels, read).empty()));
    }
    for (std::size_t at = 0; at < 500 && at < bytes.size(); ++at)
        for (const char byte : {'\0', '\x7f', '\xff'}) {
            std::string damaged = bytes;
            damaged[at] = byte;
            LayeredPicture read;
            StoredPicture colours;
            if (!reads_exr(damaged)) continue;
            read_exr(damaged, enough_pixels, read);
            read_exr(damaged, enough_pixels, colours);
        }
}

TEST_CASE("a head that claims more than the file has is refused before memory is reserved",
          "[raster]") {
    LayeredPicture small{1, 1, {{"Y", false, {0}}}, {}};
    std::string bytes = written(small);
    const std::size_t window = bytes.find("box2i") + 10;
    for (const std::size_t at : {window + 8, window + 12}) {
        bytes[at] = '\xff';
        bytes[at + 1] = '\x1f';
    }
    REQUIRE(reads_exr(bytes));
    LayeredPicture read;
    CHECK(read_exr(bytes, std::int64_t{1} << 28, read).find("more pixels") != std::string::npos);
    CHECK(read_exr(bytes, 1000, read).find("8192 by 8192") != std::string::npos);
}

}  // namespace candelabra
