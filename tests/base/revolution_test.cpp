// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/revolution.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("turns around an axis begin at x and pass z", "[base]") {
    CHECK(turn(1, 0) == 0);
    CHECK(turn(0, 1) == Approx(0.25));
    CHECK(turn(-1, 0) == 0.5);
    CHECK(turn(0, -2) == Approx(0.75));
    CHECK(turn(1, -1e-12) == Approx(1));
}

TEST_CASE("turns around a tube begin at its inner side and pass its lower side", "[base]") {
    CHECK(turn_of_tube(-1, 0) == 0);
    CHECK(turn_of_tube(0, -1) == Approx(0.25));
    CHECK(turn_of_tube(3, 0) == Approx(0.5));
    CHECK(turn_of_tube(0, 1) == Approx(0.75));
    CHECK(turn_of_tube(0, 0) == 0);
}

}  // namespace candelabra
