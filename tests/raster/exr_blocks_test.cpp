// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/exr_blocks.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("bytes are split for zlib and joined again", "[raster]") {
    CHECK(exr_split("abcdefg") == "a\x82\x82\x82\x7b\x82\x82");
    std::string bytes;
    for (int length = 0; length < 20; ++length) {
        CHECK(exr_joined(exr_split(bytes)) == bytes);
        bytes += static_cast<char>(length * 37);
    }
}

}  // namespace candelabra
