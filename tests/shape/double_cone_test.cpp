// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/double_cone.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a cone with a radius below 0 is one or two others", "[shape]") {
    const Vec3 y(0, 1, 0);
    CHECK_FALSE(is_crossed(Cone{}));
    CHECK(is_crossed(Cone{Vec3(0), 1, y, -1, false}));
    const auto two = uncrossed({Vec3(0), 3, 4.0 * y, -1, true});
    REQUIRE(two.size() == 2);
    CHECK(two[0].base_radius == 3);
    CHECK(two[0].cap == 3.0 * y);
    CHECK(two[0].cap_radius == 0);
    CHECK(two[1].base == 3.0 * y);
    CHECK(two[1].cap_radius == 1);
    CHECK(two[1].open);
    const auto one = uncrossed({Vec3(0), -3, y, 0, false});
    REQUIRE(one.size() == 1);
    CHECK(one[0].base_radius == 3);
}

TEST_CASE("scenes may have crossed cones, also in loops", "[shape]") {
    const Evaluated result = evaluated(R"(
        #macro P(A) #debug concat(str(A, 0, 2), " ") #end
        #for (I, -2, 2)
            #declare O = cone { 0, 1, 2*y, I }
            P(max_extent(O).x) P(inside(O, <0.9, 1.99, 0>)) P(trace(O, <5, 1.5, 0>, -x).x)
        #end)");
    CHECK(result.diagnostics.find("error") == std::string::npos);
    CHECK(result.printed ==
          "2.00 1.00 1.25 1.00 1.00 0.50 1.00 0.00 0.25 1.00 1.00 1.00 "
          "2.00 1.00 1.75 ");
}

}  // namespace candelabra
