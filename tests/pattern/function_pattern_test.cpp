// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/function_pattern.h"

#include <catch2/catch.hpp>

#include <limits>

namespace candelabra {

TEST_CASE("a function as a pattern begins again above 1", "[pattern]") {
    const FunctionPattern sum{make_handle<Formula>(3, 1, [](const double* in, double* out) {
        out[0] = in[0] + in[1] + in[2];
        return true;
    })};
    CHECK(evaluate(sum, Vec3(0.25, 0.5, 0)) == 0.75);
    CHECK(evaluate(sum, Vec3(1, 0, 0)) == 1);
    CHECK(evaluate(sum, Vec3(1, 1, 0.5)) == 0.5);
    CHECK(evaluate(sum, Vec3(-3, 0.5, 0)) == -2.5);
    CHECK(evaluate(sum, Vec3(std::numeric_limits<double>::quiet_NaN())) == 0);
    CHECK(evaluate(FunctionPattern{}, Vec3(1)) == 0);
}

}  // namespace candelabra
