// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/sky.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the background's transparency counts from version 3.7 on", "[world]") {
    const std::string text = "background { rgbft <1, 0.5, 0.2, 0.25, 0.5> }";
    const SharedWorld now = world_of("#version 3.7; " + text),
                      old = world_of("#version 3.6; " + text);
    CHECK(now->sky_radiance(Vec3(0, 0, 1)) == Rgb(0.5, 0.25, 0.1));
    CHECK(now->sky.background.covering() == Rgb(0.25, 0.125, 0.05));
    CHECK(now->sky.background.mirrored() == Rgb(1, 0.5, 0.2));
    CHECK(old->sky_radiance(Vec3(0, 0, 1)) == Rgb(1, 0.5, 0.2));
}

}  // namespace candelabra
