// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/lamp_sight.h"

#include "base/random.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

/// The visible solid angle of a lamp from the origin.
double solid_angle(const std::string& script) {
    const SharedWorld world = world_of("#version 3.7; " + script);
    REQUIRE(world->lights.luminaires.size() == 1);
    double sum = 0;
    constexpr int samples = 20000;
    for (int i = 0; i < samples; ++i) {
        Key key;
        key.sample = static_cast<std::uint32_t>(i);
        const auto seen = sight_of_lamp(
            *world, 0, Vec3(0), {uniform(key, Purpose::meter_u), uniform(key, Purpose::meter_v)});
        if (seen) sum += 1 / seen->density / samples;
    }
    return sum;
}

}  // namespace

TEST_CASE("the sights of a lamp add up to its visible solid angle", "[transport]") {
    using std::numbers::pi;
    const std::string glows = " pigment { rgb 1 } finish { emission 1 } } ";
    const double ball = 2 * pi * (1 - std::sqrt(1 - 1 / 9.0));
    CHECK(solid_angle("sphere { 3*z, 1" + glows) == Approx(ball).epsilon(0.002));
    // One of three axes of a cube around the eye, seen from its middle.
    CHECK(solid_angle("polygon { 5, <-1, -1, 1>, <1, -1, 1>, <1, 1, 1>, <-1, 1, 1>, <-1, -1, 1>" +
                      glows) == Approx(4 * pi / 6).epsilon(0.01));
    CHECK(solid_angle("box { <-1, -1, 1>, <1, 1, 3>" + glows) == Approx(4 * pi / 6).epsilon(0.03));
    CHECK(solid_angle("superellipsoid { <1, 1> translate 3*z" + glows) ==
          Approx(ball).epsilon(0.03));
    // Half of it hidden, and behind clear glass.
    CHECK(solid_angle("box { <0, -5, 1.5>, <5, 5, 1.6> pigment { rgb 1 } } sphere { 3*z, 1" +
                      glows) == Approx(ball / 2).epsilon(0.02));
    CHECK(solid_angle("box { <0, -5, 1.5>, <5, 5, 1.6> pigment { rgbt 1 } } sphere { 3*z, 1" +
                      glows) == Approx(ball).epsilon(0.002));
}

}  // namespace candelabra
