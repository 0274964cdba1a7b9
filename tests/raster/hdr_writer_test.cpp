// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/hdr_writer.h"

#include "raster/as_library.h"

namespace candelabra {

TEST_CASE("Radiance files are those of the library", "[raster]") {
    for (const int width : {1, 7, 8, 9, 64, 128, 129, 300, 1000})
        for (const std::uint32_t seed : {1u, 2u, 3u}) {
            INFO(width << " wide, seed " << seed);
            const RawPicture picture{
                width, 3, 3, some_values<float>(static_cast<std::size_t>(9 * width), seed),
                "hdr", {}};
            std::string bytes;
            REQUIRE(write_hdr(picture, bytes).empty());
            CHECK((bytes == as_library(picture)));
        }
}

TEST_CASE("rows of one colour, and of nothing", "[raster]") {
    for (const float value : {0.0F, 1e-33F, 1.0F, 1e37F}) {
        INFO(value);
        const RawPicture picture{300, 2, 3, std::vector<float>(1800, value), "hdr", {}};
        std::string bytes;
        REQUIRE(write_hdr(picture, bytes).empty());
        CHECK((bytes == as_library(picture)));
    }
}

}  // namespace candelabra
