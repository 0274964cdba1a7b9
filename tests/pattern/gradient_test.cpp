// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/gradient.h"

#include <catch2/catch.hpp>

TEST_CASE("gradient grows along its direction", "[pattern]") {
    struct Case {
        Vec3 direction, point;
        double value;
    };
    // As POV-Ray 3.7 prints them.
    const Case cases[] = {{{1, 0, 0}, {0.3, 0.7, -0.2}, 0.3},
                          {{1, 0, 0}, {1.3, 2.7, 3.9}, 0.3},
                          {{1, 0, 0}, {-2.45, 0.15, -7.6}, 0.55002},
                          {{1, 0, 0}, {12.34, -56.78, 90.12}, 0.34},
                          {{1, 2, 3}, {0.3, 0.7, -0.2}, 0.293987366},
                          {{1, 2, 3}, {1.3, 2.7, 3.9}, 0.917606851},
                          {{1, 2, 3}, {-2.45, 0.15, -7.6}, 0.331892014},
                          {{1, 2, 3}, {12.34, -56.78, 90.12}, 0.204566457},
                          {{0, 1, 0}, {5, 1, 5}, 1}};
    for (const Case& c : cases)
        CHECK(evaluate(Gradient{c.direction}, c.point) == Approx(c.value).margin(2e-9));
}
