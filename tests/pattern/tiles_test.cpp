// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/tiles.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("patterns that choose from lists have POV-Ray's values", "[pattern]") {
    check_patterns({
        {"brick", {1.000000000, 0.000000000, 1.000000000, 1.000000000}},
        {"brick brick_size <2,1,1.5> mortar 0.2",
         {1.000000000, 1.000000000, 1.000000000, 1.000000000}},
        {"checker", {1.000000000, 0.000000000, 1.000000000, 1.000000000}},
        {"hexagon", {0.000000000, 1.000000000, 2.000000000, 1.000000000}},
        {"cubic", {1.000000000, 2.000000000, 5.000000000, 2.000000000}},
    });
}

TEST_CASE("checker counts unit cubes, with some tolerance", "[pattern]") {
    CHECK(evaluate(Checker{}, {0, 0, 0}) == 0);
    CHECK(evaluate(Checker{}, {-1e-12, 0.5, 0.5}) == 0);
    CHECK(evaluate(Checker{}, {-1e-9, 0.5, 0.5}) == 1);
}

TEST_CASE("square has four columns in turn", "[pattern]") {
    CHECK(evaluate(Square{}, {0.5, 3, 0.5}) == 0);
    CHECK(evaluate(Square{}, {0.5, 3, 1.5}) == 1);
    CHECK(evaluate(Square{}, {1.5, 3, 1.5}) == 2);
    CHECK(evaluate(Square{}, {-0.5, 3, 0.5}) == 3);
}

TEST_CASE("tiles do not repeat their lists", "[pattern]") {
    for (const char* name : {"checker", "brick", "hexagon", "square", "triangular", "cubic"}) {
        const PatternUse use = pattern_of(name);
        CHECK(use.modifiers.frequency == 0);
        CHECK(choices(use.pattern) >= 2);
    }
}

}  // namespace candelabra
