// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the readers of raster files with OpenImageIO on files that it has written.
#pragma once

#include "raster/raster.h"
#include "support/picture_formats.h"

#include <catch2/catch.hpp>

namespace candelabra {

inline constexpr std::int64_t raster_limit = 1 << 20;

/// Returns pixels that are neither constant nor noise, of bytes or words.
template <class Number>
std::vector<Number> uneven(int width, int height, int channels) {
    std::vector<Number> values;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c)
                values.push_back(static_cast<Number>((x * x * 7 + y * 31 * (c + 1) + x * y) *
                                                     (sizeof(Number) == 2 ? 97 : 1)));
    return values;
}

inline std::string file_of(const RawPicture& picture) {
    std::string bytes;
    REQUIRE(formats().write(picture, bytes) == "");
    return bytes;
}

/// Reads the file by both readers, which must agree.
inline StoredPicture check_same(const std::string& bytes) {
    StoredPicture expected, found;
    REQUIRE(formats().read(bytes, raster_limit, expected) == "");
    REQUIRE(read_raster(bytes, raster_limit, found));
    CHECK(found.width == expected.width);
    CHECK(found.height == expected.height);
    CHECK(found.channels == expected.channels);
    CHECK(found.bits == expected.bits);
    CHECK(found.format == expected.format);
    CHECK(found.linear == expected.linear);
    CHECK(found.gamma == expected.gamma);
    CHECK((found.values == expected.values));
    CHECK((found.alpha == expected.alpha));
    return found;
}

/// Checks that truncated files are rejected without harm.
inline void check_short(const std::string& bytes) {
    StoredPicture picture;
    for (std::size_t length = 0; length + 2 < bytes.size(); ++length) {
        INFO("bytes: " << length);
        CHECK_FALSE(read_raster(bytes.substr(0, length), raster_limit, picture));
    }
    CHECK(picture.values.empty());
}

}  // namespace candelabra
