// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/camera_functions.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace candelabra {

TEST_CASE("functions of the place in the picture give a vector", "[camera]") {
    const auto formula = [](auto code) {
        return make_handle<Formula>(3, 1, [code](const double* at, double* result) {
            *result = code(at[0], at[1]);
            return std::isfinite(*result);
        });
    };
    CameraFunctions functions;
    CHECK_FALSE(functions.given());
    functions.x = formula([](double u, double) { return 4 * u; });
    functions.y = formula([](double, double v) { return v * v; });
    CHECK_FALSE(functions.given());
    functions.z = formula([](double u, double v) { return 1 / (u - v); });
    CHECK(functions.given());
    CHECK(functions.at(0.25, -0.25) == Vec3(1, 0.0625, 2));
    CHECK_FALSE(std::isfinite(functions.at(0.25, 0.25).z));
}

}  // namespace candelabra
