// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/sun.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the sun of a daylight sky is parallel light from where it stands", "[world]") {
    const LightUnits candelas{1, 1};
    Daylight day;
    day.sun = Vec2(40, 120);
    day.type = 12;  // a clear sky
    const DaylightSky clear(day, candelas);
    const auto sun = sun_of(clear, {});
    REQUIRE(sun);
    CHECK(sun->light.parallel);
    CHECK(sun->light.colour == clear.sunlight());
    CHECK(length(unit(sun->light.location) - clear.sun()) < 1e-12);
    day.type = 1;  // an overcast one
    CHECK_FALSE(sun_of(DaylightSky(day, candelas), {}));
    CHECK_FALSE(sun_of(std::nullopt, {}));
}

}  // namespace candelabra
