// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/falloff.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("patterns that fall off have POV-Ray's values", "[pattern]") {
    check_patterns({
        {"boxed", {0.300000000, 0.000000000, 0.000000000, 0.000000000}},
        {"planar", {0.300000000, 0.000000000, 0.850000000, 0.000000000}},
        {"spherical", {0.212599213, 0.000000000, 0.000000000, 0.000000000}},
        {"cylindrical", {0.639444872, 0.000000000, 0.000000000, 0.000000000}},
    });
}

TEST_CASE("what falls off is never negative", "[pattern]") {
    for (const Vec3& far : {Vec3(1e17), Vec3(-3, 2, 9)}) {
        CHECK(evaluate(Boxed{}, far) == 0);
        CHECK(evaluate(PlanarPattern{}, far) == 0);
        CHECK(evaluate(CylindricalPattern{}, far) == 0);
        CHECK(evaluate(SphericalPattern{}, far) == 0);
    }
}

}  // namespace candelabra
