// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/survey_places.h"

#include "support/ball_over_floor.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("places in a cell lie on the outsides of what is in it", "[lighting]") {
    const Box cell{Vec3(2, -2, 2), Vec3(4, 0, 4)};
    const std::vector<SurveyPlace> found = survey_places_in(cell, {}, ball_over_floor);
    REQUIRE(found.size() > 3);
    for (const SurveyPlace& each : found) {
        CHECK(each.point.position.y == Approx(-1.5));
        CHECK(each.point.normal == Vec3(0, 1, 0));
        CHECK(contains(cell, each.point.position));
    }
    // Without surfaces, any place will do.
    for (const SurveyPlace& each : survey_places_in({Vec3(5, 5, 5), Vec3(6)}, {}, ball_over_floor))
        CHECK(each.point.horizon == Horizon::both_sides);
}

TEST_CASE("places in the air of a cell have no horizon", "[lighting]") {
    const Box cell{Vec3(1, 2, 3), Vec3(2, 4, 4)};
    const std::vector<SurveyPlace> places = air_places_in(cell, {}, ball_over_floor);
    REQUIRE_FALSE(places.empty());
    for (const SurveyPlace& each : places) {
        CHECK(contains(cell, each.point.position));
        CHECK(each.point.horizon == Horizon::none);
    }
    // An eye above the floor sees none of those below it, unless all are.
    const Vec3 eye(5, 3, 5);
    for (const double top : {0.0, -2.0}) {
        const std::vector<SurveyPlace> seen =
            air_places_in({Vec3(2, -3, 2), Vec3(4, top, 4)}, {eye}, ball_over_floor);
        REQUIRE(seen.size() > 3);
        for (const SurveyPlace& each : seen) CHECK((each.point.position.y > -1.5) == (top == 0));
    }
}

}  // namespace candelabra
