// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/raster.h"

#include "raster/same.h"

namespace candelabra {

TEST_CASE("what is left to others leaves the picture as it was", "[raster]") {
    StoredPicture picture;
    picture.width = 77;
    for (const char* bytes : {"", "GIF", "GIF89a", "\xff\xd8\xff", "P6 3 3 255 ", "P7", "P1", "BM",
                              "II*", "\x89PNG", "#?RADIANCE"}) {
        CAPTURE(bytes);
        CHECK_FALSE(read_raster(bytes, raster_limit, picture));
    }
    CHECK(picture.width == 77);
}

}  // namespace candelabra
