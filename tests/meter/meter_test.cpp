// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/meter.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Meter plane() {
    Meter meter;
    meter.along = Vec3(2, 0, 0);
    meter.across = Vec3(0, 0, 3);
    return meter;
}

Meter of(Quantity quantity) {
    Meter meter = plane();
    meter.quantity = static_cast<int>(quantity);
    return meter;
}

}  // namespace

TEST_CASE("a meter that cannot measure says why", "[meter]") {
    CHECK(problem(plane()).empty());
    CHECK(problem(Meter()) ==
          "`meter` needs `points`, or a grid by `corner`, `along` and `across`");
    Meter both = plane();
    both.points = {Vec3(0)};
    CHECK(problem(both) == "`meter` has `points` and a grid: two meters are needed");
    Meter wall = plane();
    wall.across = Vec3(0, 3, 0);
    CHECK(problem(wall) == "`meter` stands upright: `direction` decides its side");
    wall.direction = Vec3(0, 0, -1);
    CHECK(problem(wall).empty());
    wall.across = wall.along;
    CHECK(problem(wall) == "`along` and `across` of `meter` have the same direction");
    Meter still = plane();
    still.direction = Vec3(0);
    CHECK(problem(still) == "`direction` of `meter` must not be zero");
    still = plane();
    still.up = Vec3(0);
    CHECK(problem(still) == "`up` of `meter` must not be zero");
}

TEST_CASE("a meter has no words that its quantity does not have", "[meter]") {
    Meter meter = plane();
    meter.eye = Vec3(0, 1.5, -60);
    CHECK(problem(meter) == "`eye` of `meter` is for `luminance`");
    meter = of(Quantity::cylindrical);
    meter.cone = 3;
    CHECK(problem(meter) == "`cone` of `meter` is for `luminance`");
    meter = plane();
    meter.road_table = "r3.csv";
    CHECK(problem(meter) == "`road_table` of `meter` is for `luminance`");
    meter = of(Quantity::luminance);
    meter.eye = Vec3(0, 1.5, -60);
    meter.road = "road";
    CHECK(problem(meter) == "`road` of `meter` is for `threshold_increment`");
    meter.road.clear();
    meter.road_table = "r3.csv";
    CHECK(problem(meter).empty());
    meter.cone = 1;
    CHECK(problem(meter) == "`meter` has a `cone` and a `road_table`, which is for single points");
    meter = Meter();
    meter.quantity = static_cast<int>(Quantity::luminance);
    meter.points = {Vec3(1), Vec3(2)};
    meter.eye = Vec3(2);
    CHECK(problem(meter) == "a point of `meter` is in its `eye`, which cannot look at it");
    meter.eye = Vec3(3);
    CHECK(problem(meter).empty());
    meter.across = Vec3(1);
    CHECK(problem(meter) == "`meter` has `points` and a grid: two meters are needed");
    meter = plane();
    meter.counts = Vec2(3, 4);
    CHECK(problem(meter).empty());
    meter.rule = static_cast<int>(GridRule::en_12464);
    CHECK(problem(meter) == "`meter` has `counts` and a rule for them: one of both is needed");
}

TEST_CASE("observers need a line of sight", "[meter]") {
    for (const Quantity quantity : {Quantity::ugr, Quantity::semi_cylindrical}) {
        Meter meter = of(quantity);
        CHECK(problem(meter) ==
              "`" + std::string(name_of(quantity)) + "` of `meter` needs `direction`");
        meter.direction = Vec3(1, 0, 0);
        CHECK(problem(meter).empty());
        meter.direction = Vec3(0, -1, 0);
        CHECK(problem(meter) == "`direction` of `meter` leads straight up or down");
    }
    Meter seen = of(Quantity::luminance);
    CHECK(problem(seen) == "`luminance` of `meter` needs `eye` or `direction`");
    seen.eye = Vec3(0, 1.5, -60);
    CHECK(problem(seen).empty());
    Meter driver = of(Quantity::threshold_increment);
    driver.direction = Vec3(1, 0, 0);
    CHECK(problem(driver) ==
          "`threshold_increment` of `meter` needs `road`, the name of a meter of luminance");
    driver.road = "road";
    CHECK(problem(driver).empty());
    CHECK(problem(of(Quantity::cylindrical)).empty());
    CHECK(unit_of(Quantity::cylindrical) == "lx");
    CHECK(unit_of(Quantity::daylight_factor) == "%");
}

}  // namespace candelabra
