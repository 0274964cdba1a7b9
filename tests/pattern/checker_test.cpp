// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/checker.h"

#include <catch2/catch.hpp>

TEST_CASE("checker counts unit cubes", "[pattern]") {
    struct Case {
        Vec3 point;
        double value;
    };
    // As POV-Ray 3.7 prints them.
    const Case cases[] = {{{0.3, 0.7, -0.2}, 1},    {{1.3, 2.7, 3.9}, 0},
                          {{-2.45, 0.15, -7.6}, 1}, {{12.34, -56.78, 90.12}, 1},
                          {{0, 0, 0}, 0},           {{-1e-12, 0.5, 0.5}, 0}};
    for (const Case& c : cases) {
        INFO(c.point.x << ' ' << c.point.y << ' ' << c.point.z);
        CHECK(evaluate(Checker{}, c.point) == c.value);
    }
}
