// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/pnm_writer.h"

#include "raster/as_library.h"

namespace candelabra {

TEST_CASE("PPM and PGM files are those of the library", "[raster]") {
    for (const int channels : {1, 3}) {
        const RawPicture picture{
            5,     4, channels, some_values<std::uint8_t>(20 * static_cast<std::size_t>(channels)),
            "ppm", {}};
        std::string bytes;
        REQUIRE(write_pnm(picture, bytes).empty());
        CHECK((bytes == as_library(picture)));
    }
}

TEST_CASE("a PPM file has neither alpha nor floats", "[raster]") {
    std::string bytes;
    CHECK_FALSE(write_pnm({1, 1, 4, some_values<std::uint8_t>(4), "ppm", {}}, bytes).empty());
    CHECK_FALSE(write_pnm({1, 1, 3, some_values<float>(3), "ppm", {}}, bytes).empty());
}

}  // namespace candelabra
