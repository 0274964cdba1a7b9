// SPDX-License-Identifier: GPL-3.0-or-later
#include "oiio/formats.h"

#include "support/picture_formats.h"

namespace candelabra {

namespace {

RawPicture two_pixels() {
    return {2, 1, 3, std::vector<std::uint8_t>{0, 51, 255, 255, 102, 0}, "png", {}};
}

}  // namespace

TEST_CASE("stored values come back as they were", "[formats]") {
    std::string bytes;
    REQUIRE(formats().write(two_pixels(), bytes) == "");
    StoredPicture stored;
    REQUIRE(formats().read(bytes, 100, stored) == "");
    CHECK(stored.width == 2);
    CHECK(stored.height == 1);
    CHECK(stored.channels == 3);
    CHECK_FALSE(stored.linear);
    const std::vector<float> expected = {0, 0.2f, 1, 1, 0.4f, 0};
    REQUIRE(stored.values.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(stored.values[i] == Approx(expected[i]));
    CHECK(formats().read(bytes, 1, stored) == "its header has 2 by 1 pixels");
}

TEST_CASE("what cannot be stored is said", "[formats]") {
    RawPicture picture = two_pixels();
    picture.extension = "nonsense";
    std::string bytes;
    CHECK(formats().write(picture, bytes) != "");
    StoredPicture stored;
    CHECK(formats().read("", 100, stored) != "");
}

}  // namespace candelabra
