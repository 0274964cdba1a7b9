// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/bands.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("patterns of bands have POV-Ray's values", "[pattern]") {
    check_patterns({
        {"gradient x", {0.300000000, 0.300000000, 0.550020000, 0.340000000}},
        {"gradient <1,2,3>", {0.293987366, 0.917606851, 0.331892014, 0.204566457}},
        {"leopard", {0.061020291, 0.054938970, 0.235628124, 0.016062270}},
        {"marble", {0.600000000, 0.599980000, 0.899960000, 0.679760000}},
        {"marble turbulence 0.5", {0.633789221, 0.224375375, 0.608445810, 0.624861073}},
        {"marble turbulence <0.3,2,5> octaves 3 lambda 3 omega 0.25 noise_generator 1",
         {0.855193602, 0.956221703, 0.213294065, 0.975187876}},
        {"onion", {0.787400787, 0.918333051, 0.986551196, 0.228067221}},
        {"radial", {0.093573521, 0.801208191, 0.299632451, 0.771658165}},
        {"radial frequency 6", {0.561441125, 0.807209147, 0.797784707, 0.629908989}},
        {"spiral1 5", {0.521290671, 0.078984243, 0.888125240, 0.788546770}},
        {"spiral2 3", {0.519332134, 0.743001541, 0.119895946, 0.267639094}},
        {"wood", {0.476845379, 0.006710374, 0.909135083, 0.209751708}},
        {"wood turbulence <0.1,0.3,0.5>", {0.321502416, 0.615712263, 0.828174756, 0.061438229}},
    });
}

TEST_CASE("a whole step of a gradient stays 1", "[pattern]") {
    CHECK(value_at(pattern_of("gradient y"), Vec3(5, 1, 5)) == 1);
    CHECK(value_at(pattern_of("gradient y"), Vec3(5, 1.25, 5)) == Approx(0.25));
}

TEST_CASE("turbulence displaces what is no marble or wood", "[pattern]") {
    const Vec3 point(0.3, 0.7, -0.2);
    CHECK(pattern_of("marble turbulence 1").place(point) == point);
    CHECK(pattern_of("wood turbulence 1").place(point) == point);
    CHECK(pattern_of("bozo turbulence 1").place(point) != point);
}

}  // namespace candelabra
