// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/image.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("pixels are stored row by row from the top, black at first", "[base]") {
    Image image(3, 2);
    REQUIRE(image.pixels.size() == 6);
    CHECK(image.at(2, 1) == Rgb(0));
    image.at(1, 1) = Rgb(1, 2, 3);
    CHECK(image.pixels[4] == Rgb(1, 2, 3));
    CHECK(Image().pixels.empty());
}

}  // namespace candelabra
