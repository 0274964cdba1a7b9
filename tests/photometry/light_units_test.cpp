// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/light_units.h"

#include "photometry/light_colour.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

using std::numbers::pi;

TEST_CASE("radiance and luminance are in proportion by the white", "[photometry]") {
    const LightUnits units{1, 200};
    CHECK(units.luminance(light_luminance({12, 6, 2})) == Approx(1397.41).epsilon(1e-5));
    CHECK(units.radiance(200) == Approx(1));
    // A colour of 1 lights a surface with pi times the white.
    CHECK(units.colour(628.319) == Approx(1).epsilon(1e-5));
}

TEST_CASE("flux and intensity take the length of a unit into account", "[photometry]") {
    const LightUnits metres{1, 200}, centimetres{0.01, 200};
    // An emitting ball of radius 5 cm, as bright as it is, gives 32.2355 lx at 2 m.
    const double radiance = 100 * light_luminance({1, 0.8, 0.5});
    const double candela = metres.luminance(radiance) * pi * 0.05 * 0.05;
    CHECK(candela / 4 == Approx(32.2355).epsilon(1e-5));
    CHECK(metres.lumens(radiance * 4 * pi * 0.05 * 0.05) == Approx(4 * pi * candela));
    CHECK(centimetres.lumens(radiance * 4 * pi * 5 * 5) == Approx(4 * pi * candela));
    for (const LightUnits& units : {metres, centimetres}) {
        CHECK(units.flux(units.lumens(7)) == Approx(7));
        // The colour at the distance of 2 m gives that illuminance.
        const double away = 2 / units.metres;
        CHECK(units.intensity(candela) / (away * away) == Approx(units.colour(candela / 4)));
    }
}

}  // namespace candelabra
