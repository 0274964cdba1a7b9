// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/number_functions.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("functions of numbers have POV-Ray's values", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"P(abs(-2)) P(ceil(1.2)) P(floor(-1.2)) P(int(-1.9)) P(int(1e10))",
         "2.000000 2.000000 -2.000000 -1.000000 -2147483648.000000"},
        {"P(sin(pi/2)) P(degrees(pi)) P(radians(180)) P(atan2(1,0)) P(sqrt(9))",
         "1.000000 180.000000 3.141593 1.570796 3.000000"},
        {"P(ln(exp(2))) P(log(1000)) P(pow(2,10)) P(-pow(2,2)) P(pow(2,3)*-1)",
         "2.000000 3.000000 1024.000000 -4.000000 -8.000000"},
        {"P(div(7,2)) P(div(-7,2)) P(mod(-7,3)) P(mod(5.5,2))",
         "3.000000 -3.000000 -1.000000 1.500000"},
        {"P(min(3,1,2)) P(max(1,3,2)) P(max(7))", "1.000000 3.000000 7.000000"},
        {"P(select(-1,1,2)) P(select(0,1,2)) P(select(0,1,2,3)) P(select(5,1,2,3))",
         "1.000000 2.000000 2.000000 3.000000"},
        {"P(bitwise_and(12,10)) P(bitwise_or(12,10)) P(bitwise_xor(12,10,1))",
         "8.000000 14.000000 7.000000"},
        {"P(vdot(2,<1,2,3>)) P(vlength(1)) P(vdot(<1,2>,<3,4,5>))", "12.000000 1.732051 11.000000"},
        {"V(3,vcross(x,y)) V(3,vnormalize(<0,3,4>)) V(3,vrotate(x,90*y)) V(3,vrotate(y,90*x))",
         "<0.0000,0.0000,1.0000> <0.0000,0.6000,0.8000> <0.0000,0.0000,-1.0000> "
         "<0.0000,0.0000,1.0000>"},
        {"V(3,vaxis_rotate(x,z,90)) V(3,vaxis_rotate(x,5*z,90))",
         "<0.0000,1.0000,0.0000> <0.0000,1.0000,0.0000>"},
        {"V(3,vturbulence(2,.5,6,<1.5,2.5,3.5>)) V(3,vturbulence(2.3,.7,3,<-1.1,.2,7.7>))",
         "<0.0696,-0.0389,0.0250> <-0.7165,0.2786,-0.2594>"},
        {"V(3,vturbulence(2,.5,99,<1,2,3>)) V(3,vturbulence(2,.5,1,<1.5,2.5,3.5>)) "
         "V(3,vturbulence(2,.5,6,0))",
         "<-0.3900,-0.5329,0.4165> <-0.0547,-0.0043,0.0022> <-0.8730,0.7107,-0.9051>"},
    }));
    INFO(script);
    std::string got = printed(script);
    for (std::size_t at; (at = got.find("-0.0000")) != std::string::npos;) got.erase(at, 1);
    CHECK(got == result);
}

TEST_CASE("what a function of numbers cannot take is reported", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare a = sqrt(-1);", "error: there is no square root of -1\n"},
        {"#declare a = ln(0);", "error: there is no logarithm of 0\n"},
        {"#declare a = log(-2);", "error: there is no logarithm of -2\n"},
        {"#declare a = atan2(0, 0);", "error: atan2(0, 0) has no direction\n"},
        {"#declare a = pow(0, 0);", "error: 0 to the power of 0 has no value\n"},
        {"#declare a = acos(2);",
         "warning: the argument is 2; outside -1 to 1 the nearer end is taken\n"},
        {"#declare a = vnormalize(<0, 0, 0>);",
         "warning: the zero vector has no direction; it stays zero\n"},
        {"#declare a = vaxis_rotate(x, 0*y, 9);",
         "warning: the zero vector is no axis; the result is no vector\n"},
        {"#declare a = max(1, x);",
         "error: `max` takes a number here, but this is a vector of 3\n"},
        {"#declare a = vcross(x, rgb 1);",
         "error: `vcross` takes a vector of 3 here, but this is a colour\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("int truncates through 32 bits", "[interpret]") {
    CHECK(to_integer(2.9) == 2);
    CHECK(to_integer(-2.9) == -2);
    CHECK(to_integer(2147483647.5) == 2147483647);
    CHECK(to_integer(2147483648.0) == -2147483648.0);
    CHECK(to_integer(NAN) == -2147483648.0);
}

}  // namespace candelabra
