// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/interior.h"

#include "vocabulary/written.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE(
    "an interior starts without an index of refraction of its own and is written in its own words",
    "[surface]") {
    Interior interior;
    CHECK(interior.ior == 0);
    CHECK(written_fields(Interior::vocabulary, &interior).empty());
    interior.ior = 1.5;
    CHECK(written_fields(Interior::vocabulary, &interior) == "ior 1.5");
}

TEST_CASE("light is dimmed inside as POV-Ray 3.7 does it", "[surface]") {
    Interior interior;
    CHECK(attenuation(interior, 5) == Rgb(1));
    interior.fade_distance = 2;
    interior.fade_power = 2;
    CHECK(attenuation(interior, 2) == Rgb(0.5));
    interior.fade_color = Rgb(1, 0.5, 0);
    CHECK(attenuation(interior, 2) == Rgb(1, 0.75, 0.5));
    interior.fade_power = 1001;
    CHECK(attenuation(interior, 4).b == Approx(std::exp(-2)));
}

}  // namespace candelabra
