// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/jpeg.h"

#include "raster/same.h"

namespace candelabra {

TEST_CASE("JPEG files are read as by the library", "[raster]") {
    for (const int channels : {1, 3}) {
        const RawPicture picture{37,    21, channels, uneven<std::uint8_t>(37, 21, channels),
                                 "jpg", {}};
        StoredPicture read;
        if (read_raster(file_of(picture), raster_limit, read)) check_same(file_of(picture));
    }
}

TEST_CASE("JPEG files that are damaged or too large are left to the library", "[raster]") {
    const std::string bytes = file_of({17, 9, 3, uneven<std::uint8_t>(17, 9, 3), "jpg", {}});
    check_short(bytes);
    CHECK(!read_jpeg(bytes, 17 * 9 - 1));
    std::string large = bytes;
    const std::size_t frame = large.find("\xff\xc0");
    REQUIRE(frame != large.npos);
    large.replace(frame + 5, 4, "\x7f\xff\x7f\xff");
    CHECK(!read_jpeg(large, std::int64_t{1} << 40));
}

}  // namespace candelabra
