// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/raster.h"

#include "raster/same.h"

#include <cstring>

namespace candelabra {

TEST_CASE("rasters are known by their first bytes", "[raster]") {
    for (const char* beginning : {"GIF89a", "GIF87a", "\xff\xd8\xff", "P6 1 1 255", "MM\0*"})
        CHECK(is_raster(std::string(beginning, beginning[0] == 'M' ? 4 : std::strlen(beginning))));
    for (const char* beginning : {"", "GIF", "P7", "P1", "BM", "\x89PNG", "#?RADIANCE"})
        CHECK_FALSE(is_raster(beginning));
}

TEST_CASE("what is left to others leaves the picture as it was", "[raster]") {
    StoredPicture picture;
    picture.width = 77;
    CHECK_FALSE(read_raster("P6 3 3 255 ", raster_limit, picture));
    CHECK_FALSE(read_raster("BM", raster_limit, picture));
    CHECK(picture.width == 77);
}

}  // namespace candelabra
