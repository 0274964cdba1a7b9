// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/julia_orbit.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("orbits stay or escape as in POV-Ray", "[shape]") {
    JuliaFractal julia;
    julia.parameter = Vec4(-0.083, 0, -0.83, -0.025);
    julia.max_iteration = 8;
    CHECK(julia_orbit(julia, Vec3(0.1, 0.2, 0.3)).stays);
    CHECK_FALSE(julia_orbit(julia, Vec3(1.2, 0, 0)).stays);
    CHECK(julia_radius(julia) == Approx(1.8345).margin(1e-4));
    julia.algebra = hypercomplex_numbers;
    julia.parameter = Vec4(-0.083, 0, -0.43, -0.025);
    CHECK(julia_orbit(julia, Vec3(0.1, 0.2, 0.3)).stays);
    CHECK(julia_radius(julia) == 4);
}

}  // namespace candelabra
