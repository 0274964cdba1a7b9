// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/quilted.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("a quilt has POV-Ray's values", "[pattern]") {
    check_patterns({
        {"quilted", {0.214742407, 0.267049704, 0.143735690, 0.275785312}},
        {"quilted control0 0.2 control1 -0.5",
         {0.001528748, 0.003209404, 0.001870768, 0.003832999}},
    });
}

TEST_CASE("cubes of negative whole numbers begin above them", "[pattern]") {
    CHECK(evaluate(Quilted{}, {-1, 0.5, 0.5}) == Approx(evaluate(Quilted{}, {1, 0.5, 0.5})));
    CHECK(quilted_tilt(Quilted{}, {-1, 0.5, 0.5}).x > 0);
    CHECK(quilted_tilt(Quilted{}, {1, 0.5, 0.5}).x < 0);
    CHECK(quilted_tilt(Quilted{}, {0.5, 0.5, 0.5}) == Vec3(0));
}

}  // namespace candelabra
