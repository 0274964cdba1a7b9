// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/places.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("grids have as many points as their standards want", "[meter]") {
    struct Row {
        double along, across;
        std::size_t points_along, points_across;
    };
    // By the formula; the standard's own table rounds distances first.
    for (const Row& row : {Row{7.2, 5.4, 9, 7}, Row{0.4, 0.4, 4, 4}, Row{1, 1, 5, 5},
                           Row{2, 2, 6, 6}, Row{5, 5, 8, 8}, Row{10, 10, 10, 10},
                           Row{25, 25, 13, 13}, Row{50, 50, 16, 16}, Row{100, 100, 20, 20}}) {
        CAPTURE(row.along, row.across);
        const GridCounts counts = points_by_en_12464(row.along, row.across);
        CHECK(counts.along == row.points_along);
        CHECK(counts.across == row.points_across);
    }
    // Of a strip the shorter side says how far points are apart.
    CHECK(points_by_en_12464(20, 2).across == 6);
    CHECK(points_by_en_12464(20, 2).along == 62);
    CHECK(points_by_en_12464(5, 0).across == 1);
    CHECK(points_by_en_13201(35, 7, 2).along == 12);
    CHECK(points_by_en_13201(35, 7, 2).across == 6);
    CHECK(points_by_en_13201(35, 7, 0).across == 5);
    CHECK(points_by_en_13201(30, 3, 0).along == 10);
    CHECK(points_by_en_13201(30, 3, 0).across == 3);
}

TEST_CASE("the points of a grid lie in the middles of its cells", "[meter]") {
    Meter meter;
    meter.corner = Vec3(1, 0.8, 2);
    meter.along = Vec3(4, 0, 0);
    meter.across = Vec3(0, 0, 2);
    meter.counts = Vec2(4, 2);
    const auto places = places_of(meter, 1);
    REQUIRE(places.size() == 8);
    CHECK(places[0].position == Vec3(1.5, 0.8, 2.5));
    CHECK(places[3].position == Vec3(4.5, 0.8, 2.5));
    CHECK(places[4].position == Vec3(1.5, 0.8, 3.5));
    // It faces up, whichever way around its sides are.
    CHECK(places[0].direction == Vec3(0, 1, 0));
    std::swap(meter.along, meter.across);
    CHECK(places_of(meter, 1)[0].direction == Vec3(0, 1, 0));
    meter.direction = Vec3(0, 0, -2);
    CHECK(places_of(meter, 1)[0].direction == Vec3(0, 0, -1));
    meter.eye = Vec3(1, 0.8, 0);
    CHECK(length(places_of(meter, 1)[0].direction - unit(Vec3(0.25, 0, 3))) < 1);
    CHECK(dot(places_of(meter, 1)[0].direction, places_of(meter, 1)[0].position - *meter.eye) > 0);
    meter.counts = Vec2(10000, 10000);
    CHECK(places_of(meter, 1).empty());
}

TEST_CASE("lines and points are meters, too, and standards count in metres", "[meter]") {
    Meter line;
    line.along = Vec3(0, 0, 10);
    line.counts = Vec2(5, 1);
    CHECK(places_of(line, 1).size() == 5);
    CHECK(places_of(line, 1)[2].position == Vec3(0, 0, 5));
    line.counts.reset();
    CHECK(places_of(line, 1).size() == 10);
    CHECK(places_of(line, 0.1).size() == 5);
    Meter points;
    points.points = {Vec3(1), Vec3(2)};
    CHECK(places_of(points, 1).size() == 2);
    CHECK(places_of(points, 1)[1].direction == Vec3(0, 1, 0));
    Meter road;
    road.rule = static_cast<int>(GridRule::en_13201);
    road.quantity = static_cast<int>(Quantity::luminance);
    road.along = Vec3(35, 0, 0);
    road.across = Vec3(0, 0, 7);
    road.lanes = 2;
    CHECK(places_of(road, 1).size() == 72);
}

}  // namespace candelabra
