// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/pnm.h"

#include "raster/same.h"

namespace candelabra {

TEST_CASE("PGM and PPM files of bytes are read as by the library", "[raster]") {
    for (const int channels : {1, 3}) {
        const std::string name = channels == 1 ? "pgm" : "ppm";
        check_same(file_of({5, 7, channels, uneven<std::uint8_t>(5, 7, channels), name, {}}));
    }
    check_short(file_of({5, 7, 3, uneven<std::uint8_t>(5, 7, 3), "ppm", {}}));
}

TEST_CASE("PGM and PPM files of text are read as by the library", "[raster]") {
    check_same("P2\n# made by hand\n3 2\n255\n0 1 2\n100 200 255\n");
    check_same("P3 1 2 255 0 1 2 100 200 255");
    check_short("P3\n1 2 255 0 1 2 100 200 255");
}

TEST_CASE("PNM files of other ranges and kinds are left to the library", "[raster]") {
    for (const std::string& file : std::vector<std::string>{
             "P2 1 1 15 7", "P2 1 1 65535 7", "P1 1 1 1", "P2 1 1 255 256", "P2 0 1 255 1",
             "P5 99999999 99999999 255 a", "P6 2000 2000 255 a"})
        CHECK_FALSE(read_pnm(file, raster_limit));
}

}  // namespace candelabra
