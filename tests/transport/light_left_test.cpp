// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_left.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

const char* const clear = " pigment { rgbt 1 } hollow interior { media { absorption 0.5 } } }";

double left(const World& world, double distance, bool in_atmosphere = true) {
    const Ray ray{Vec3(0, 0, -5), Vec3(0, 0, 1)};
    return light_left(world, {.ray = ray, .distance = distance, .in_atmosphere = in_atmosphere}, {})
        .x;
}

}  // namespace

TEST_CASE("media dim light on the parts of its way that they fill", "[transport]") {
    const std::string box = "box { <-9, -9, 0>, <9, 9, 2>";
    const World slab = world_of(box + clear);
    CHECK(left(slab, 20) == Approx(std::exp(-1)));
    CHECK(left(slab, 6) == Approx(std::exp(-0.5)));
    CHECK(left(slab, 4) == 1);
    CHECK(left(world_of(box + " no_shadow" + clear), 20) == 1);
    const World two = world_of(box + clear + "sphere { <0, 0, 2>, 1" + clear);
    CHECK(left(two, 20) == Approx(std::exp(-2)));
    const World solid =
        world_of(box + " pigment { rgbt 1 } interior { media { absorption 0.5 } } }");
    CHECK(left(solid, 20) == 1);
}

TEST_CASE("media outside of solids dim the whole way of light", "[transport]") {
    const World world = world_of("media { absorption 0.1 } box { -1, 1 pigment { rgbt 1 } }");
    CHECK(left(world, 10) == Approx(std::exp(-1)));
    CHECK(left(world, 10, false) == 1);
    CHECK(left(world, 1e20) == 0);
}

}  // namespace candelabra
