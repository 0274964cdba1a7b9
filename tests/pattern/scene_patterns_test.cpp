// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/scene_patterns.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("the brightness of a pigment is a pattern", "[pattern]") {
    const PatternUse use = pattern_of(
        "pigment_pattern { gradient x color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 1, 0>] } } scale 2");
    CHECK(value_at(use, Vec3(1, 0, 0)) == Approx((0.297 + 0.589) / 2));
}

TEST_CASE("what borrows from nothing is 0", "[pattern]") {
    CHECK(PointFunction()(Vec3(1), {}) == 0);
    CHECK(evaluate(Average{}, Vec3(1)) == 0);
}

}  // namespace candelabra
