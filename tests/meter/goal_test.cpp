// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/goal.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("goals are errors in per cent, of all or of some quantities", "[meter]") {
    const auto all = read_meter_goal("2%");
    REQUIRE(all);
    CHECK(all->error == Approx(0.02));
    CHECK(all->counts(Quantity::ugr));
    const auto lux = read_meter_goal("lux 0.5%");
    REQUIRE(lux);
    CHECK(lux->error == Approx(0.005));
    CHECK(lux->counts(Quantity::cylindrical));
    CHECK_FALSE(lux->counts(Quantity::luminance));
    CHECK(read_meter_goal("nit 1%")->counts(Quantity::luminance));
    CHECK(read_meter_goal("ugr 1%")->counts(Quantity::ugr));
    CHECK_FALSE(read_meter_goal("ugr 1%")->counts(Quantity::illuminance));
    for (const char* wrong : {"", "2", "lux", "lux 2", "lx 2%", "lux -1%", "0%", "101%", "lux x%",
                              "nan%", "lux  2%", "%", "1e-9%"}) {
        CAPTURE(wrong);
        CHECK_FALSE(read_meter_goal(wrong));
    }
}

}  // namespace candelabra
