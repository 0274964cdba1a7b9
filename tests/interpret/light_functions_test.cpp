// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/light_functions.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("amounts of light become numbers of the scene", "[interpret]") {
    // A unit is a centimetre, and a radiance of 1 is 200 cd/m2, unless the scene says otherwise.
    CHECK(
        printed("P(nit(3000)) P(lux(628.318531)) P(candela(1000)) P(lumen(800)) P(watt(8, 100))") ==
        "15.000000 1.000000 15915.494309 12732.395447 12732.395447");
    CHECK(printed("P(lumen(0))") == "0.000000");
}

TEST_CASE("colours of light have luminance 1", "[interpret]") {
    CHECK(printed("V(3, kelvin(2700)) V(3, kelvin(6504, \"daylight\")) V(3, kelvin(2700, "
                  "\"planck\"))") ==
          "<1.9351,0.8036,0.1918> <0.9994,1.0003,0.9991> <1.9351,0.8036,0.1918>");
    CHECK(printed("V(3, wavelength(450))") == printed("V(3, wavelength(450.0))"));
}

TEST_CASE("amounts and temperatures without meaning are refused", "[interpret]") {
    CHECK(printed("P(lumen(-1))") ==
          "error: an amount of light must be at least 0, but this is -1\n");
    CHECK(printed("P(watt(60, 0))") ==
          "error: the efficacy, in lumens per watt, must be above 0 and at most 683, but this is "
          "0\n");
    CHECK(printed("P(kelvin(500))") ==
          "error: the temperature must be between 1000 and 25000, but this is 500\n");
    CHECK(printed("P(kelvin(3000, \"daylight\"))") ==
          "error: the temperature of daylight must be between 4000 and 25000, but this is 3000\n");
    CHECK(printed("P(kelvin(3000, \"candle\"))") ==
          "error: `candle` is no kind of light here; there are \"planck\" (a glowing body) and "
          "\"daylight\"\n");
    CHECK(printed("P(wavelength(300))") ==
          "error: the wavelength, in nanometres, must be between 380 and 780, but this is 300\n");
    CHECK(printed("P(lux(\"a\"))").starts_with("error: `lux` takes a number here"));
}

}  // namespace candelabra
