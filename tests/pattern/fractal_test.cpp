// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/fractal.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("fractals have POV-Ray's values", "[pattern]") {
    check_patterns({
        {"mandel 30", {0.133333333, 0.000000000, 0.000000000, 0.000000000}},
        {"mandel 30 exponent 3", {1.000000000, 0.000000000, 0.000000000, 0.000000000}},
        {"mandel 30 exponent 4 exterior 2,0.3",
         {1.000000000, 0.013920000, 0.830962500, 0.217762304}},
        {"mandel 20 exponent 6 interior 1,1", {0.100000000, 0.000000000, 0.000000000, 0.000000000}},
        {"julia <0.353,0.288>,30", {1.000000000, 0.000000000, 0.000000000, 0.000000000}},
        {"julia <0.1,-0.5>,30 exponent 5 interior 4,0.5 exterior 0,.3",
         {0.009808039, 0.300000000, 0.300000000, 0.300000000}},
        {"magnet 1 mandel 25", {1.000000000, 0.160000000, 0.080000000, 0.040000000}},
        {"magnet 2 mandel 25 interior 1,0.1 exterior 4,0.01",
         {0.057986135, 0.009891307, 0.009990887, 0.010011135}},
        {"magnet 1 julia <0.4,0.6>,25 exterior 3,0.2",
         {1.000000000, 1.000000000, 1.000000000, 0.009683591}},
        {"magnet 2 julia <1.4,0.6>,25 exterior 5,0.2 interior 5,.5",
         {0.000000357, 0.000000000, 0.000000002, 0.003458938}},
    });
    // The orbits go so far out that rounding errors are visible.
    check_patterns({{"mandel 20 exponent 5 exterior 6,0.1 interior 1,0.7",
                     {0.771622548, 0.100162309, 0.148562221, 0.421687677}}},
                   2e-8);
}

}  // namespace candelabra
