// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/atmosphere.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

TEST_CASE("fog veils what is behind it, and not inside of solids", "[transport]") {
    const SharedWorld world = world_of(
        "fog { rgb <1, 0.5, 0> distance 4 } sphere { 0, 1 } "
        "sphere { 9, 1 hollow }");
    PathState path;
    path.ray = {Vec3(0), Vec3(0, 0, 1)};
    const Veil veil = veil_along(*world, path, 4);
    const double left = std::exp(-1);
    CHECK(veil.transmittance.r == Approx(left));
    CHECK(veil.through(Rgb(0)).g == Approx(0.5 * (1 - left)));
    CHECK(veil.through(Rgb(1)).b == Approx(left));
    path.media.push_back(1);
    CHECK(veil_along(*world, path, 4).transmittance.r == Approx(left));
    path.media.push_back(0);
    CHECK(veil_along(*world, path, 4).transmittance == Rgb(1));
    CHECK(veil_along(*world, path, 4).added == Rgb(0));
}

TEST_CASE("one veil before another", "[medium]") {
    const Veil near{Rgb(0.5), Rgb(1)}, far{Rgb(0.25), Rgb(2)};
    CHECK(near.before(far).through(Rgb(8)) == near.through(far.through(Rgb(8))));
}

}  // namespace candelabra
