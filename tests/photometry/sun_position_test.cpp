// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/sun_position.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the sun stands where almanacs say", "[photometry]") {
    struct Row {
        const char* name;
        Vec2 place;
        Vec3 date;
        double hours, height, azimuth;
    };
    // Golden, Colorado: the example of NREL's algorithm, whose height is without refraction.
    const Row rows[] = {
        {"Golden", {39.742476, -105.1786}, {2003, 10, 17}, 12 + 30.5 / 60 + 7, 39.8722, 194.3402},
        {"solstice on the tropic", {23.436, 0}, {2026, 6, 21}, 12 + 1.9 / 60, 89.97, -1},
        {"solstice in the south", {-52.5, 13.4}, {2026, 12, 21}, 11.08, 60.9, -1},
        {"midnight in summer", {70, 25}, {2026, 6, 21}, 22.35, 3.43, -1},
    };
    for (const Row& row : rows) {
        CAPTURE(row.name);
        const SunPosition found = sun_position(row.place, row.date, row.hours);
        CHECK(found.height == Approx(row.height).margin(0.05));
        if (row.azimuth >= 0) CHECK(found.azimuth == Approx(row.azimuth).margin(0.05));
    }
}

TEST_CASE("the sun rises in the east and passes the south", "[photometry]") {
    const Vec2 berlin{52.5, 13.4};
    const Vec3 equinox{2026, 3, 20};
    CHECK(sun_position(berlin, equinox, 5.2).azimuth == Approx(90).margin(2));
    CHECK(sun_position(berlin, equinox, 12 - 13.4 / 15 + 0.12).azimuth == Approx(180).margin(0.3));
    CHECK(sun_position(berlin, equinox, 17.2).azimuth == Approx(269).margin(2));
    CHECK(sun_position(berlin, equinox, 23).height < -30);
    // South of the equator it passes the north.
    const double azimuth = sun_position({-33.9, 151.2}, equinox, 12 - 151.2 / 15 + 0.12).azimuth;
    CHECK((azimuth < 1 || azimuth > 359));
}

TEST_CASE("hours may lie outside of their day", "[photometry]") {
    const SunPosition late = sun_position({10, 170}, {2026, 5, 4}, -3);
    const SunPosition before = sun_position({10, 170}, {2026, 5, 3}, 21);
    CHECK(late.height == Approx(before.height));
    CHECK(late.azimuth == Approx(before.azimuth));
}

TEST_CASE("days are counted from the first of January", "[photometry]") {
    CHECK(day_of_year({2026, 1, 1}) == 1);
    CHECK(day_of_year({2026, 12, 31}) == 365);
    CHECK(day_of_year({2024, 3, 1}) == 61);
    CHECK(day_of_year({1900, 3, 1}) == 60);
}

}  // namespace candelabra
