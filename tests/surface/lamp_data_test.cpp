// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/lamp_data.h"

#include "photometry/light_colour.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a lamp's temperature gives its emission a hue, and keeps its luminance", "[surface]") {
    LampData lamp;
    CHECK(lamp_emission(lamp, Rgb(0)) == Rgb(1));
    CHECK(lamp_emission(lamp, Rgb(3, 2, 1)) == Rgb(3, 2, 1));
    lamp.temperature = 2700;
    const Rgb warm = lamp_emission(lamp, Rgb(4));
    CHECK(light_luminance(warm) == Approx(4));
    CHECK(warm.r > warm.b);
    // To state the same once more changes nothing.
    const Rgb again = lamp_emission(lamp, warm);
    for (int channel = 0; channel < 3; ++channel)
        CHECK(again[channel] == Approx(warm[channel]).epsilon(1e-6));
}

TEST_CASE("a lamp has the flux that it states", "[surface]") {
    LampData lamp;
    CHECK_FALSE(lamp.has_flux());
    lamp.flux = 5;
    CHECK(lamp.has_flux());
    CHECK(lamp.total_flux() == 5);
}

}  // namespace candelabra
