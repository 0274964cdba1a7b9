// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/splines.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("splines give POV-Ray's values in the language", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare s=spline{0,<1,2,3> 1,<4,5,6> 3,<0,0,0>} V(3,s(-1)) V(3,s(.25)) V(3,s(9))",
         "<1.0000,2.0000,3.0000> <1.7500,2.7500,3.7500> <0.0000,0.0000,0.0000>"},
        {"#declare s=spline{2,<4,4> 0,<0,0> 1,<1,1>} V(2,s(.5)) V(2,s(1.5))",
         "<0.5000,0.5000> <2.5000,2.5000>"},
        {"#declare s=spline{0,<1,2> 1,<4,5,6>} V(3,s(.5)) #declare s=spline{0,1 1,2} V(2,s(.5))",
         "<2.5000,3.5000,3.0000> <1.5000,1.5000>"},
        {"#declare s=spline{linear_spline 0,<0,0> 1,<1,1> 2,<4,8> 3,<9,27>} "
         "V(2,s(1.5,natural_spline)) V(2,s(1.5,cubic_spline)) V(2,s(1.5,quadratic_spline)) "
         "V(2,s(1.5))",
         "<2.2000,3.1500> <2.2500,3.3750> <2.2500,3.7500> <2.5000,4.5000>"},
        {"#declare s=spline{0,<0,0> 1,<1,1>} #declare s2=spline{s cubic_spline 2,<3,3> 3,<0,0>} "
         "V(2,s2(1.5)) V(2,s(1.5))",
         "<2.2500,2.2500> <1.0000,1.0000>"},
        {"#declare s=spline{0,<1,2,3> 1,<4,5,6>} P(s(.5).y) V(3,s(.5)*2)",
         "3.500000 <5.0000,7.0000,9.0000>"},
        {"#macro A(s) V(2,s(.5)) #end #declare sp=spline{0,<0,0> 1,<1,1>} A(sp)",
         "<0.5000,0.5000>"},
        {"#declare s=spline{0,<0,0,0> 4,<4,8,0>} #declare p=0; #for(i,0,4) #declare p=p+s(i); #end "
         "V(3,p)",
         "<10.0000,20.0000,0.0000>"},
        {"#declare s=spline{#for(i,0,3) i, <i,i*i> #end} V(2,s(2.5))", "<2.5000,6.5000>"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("a wrong spline is reported", "[interpret]") {
    const auto [script, message] = GENERATE(table<std::string, std::string>({
        {"#declare s=spline{linear_spline}", "a spline needs points"},
        {"#declare s=spline{0,<1,2> 1}", "this t has no point: spline { 0, <1, 2, 3> 1, ... }"},
        {"#declare s=spline{<1,2>,0}", "the number t comes before its point: 0, <1, 2, 3>"},
        {"#declare s=spline{0,\"a\"}",
         "a spline consists of numbers and points, and this is a string"},
        {"#declare s=spline{0,<1,2>} P(s())", "spline `s` takes one number"},
        {"#declare s=spline{0,<1,2>} P(s(1,2))", "spline `s` takes one number"},
        {"#declare s=spline{0,<1,2>} P(s(x))",
         "the argument of `s` must be a number, but it is a vector of 3"},
        {"#declare s=spline{0,nope}", "nothing is declared as `nope`"},
    }));
    INFO(script);
    CHECK(printed(script) == "error: " + message + "\n");
}

}  // namespace candelabra
