// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("expressions have POV-Ray's values", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"P(.5) P(5.) P(1e3) P(1.5E-2)", "0.500000 5.000000 1000.000000 0.015000"},
        {"#declare a=<1,2,3>; P(2*.5) P(a.x) P(1.e2)", "1.000000 1.000000 100.000000"},
        {"P(1+2*3) P(2-3-4) P(-2*-3) P(8/2/2)", "7.000000 -5.000000 6.000000 2.000000"},
        {"P((1<2<3)) P((3>2>1)) P((1|0&0))", "1.000000 0.000000 0.000000"},
        {"P((1=1+1e-11)) P((1<=1-1e-11)) P((1!=1+1e-11)) P((1<1))",
         "1.000000 1.000000 0.000000 0.000000"},
        {"P(!0) P(!3) P(!1e-11) P(!!2)", "1.000000 0.000000 1.000000 1.000000"},
        {"P((1?2:3)) P((0?2:1?4:5)) P((1e-11?1:2))", "2.000000 4.000000 2.000000"},
        {"V(4,<1,2>+<1,2,3,4>) V(3,2+<1,2,3>) V(3,x*<5,6,7>) V(2,u+1)",
         "<2.0000,4.0000,3.0000,4.0000> <3.0000,4.0000,5.0000> <5.0000,0.0000,0.0000> "
         "<2.0000,1.0000>"},
        {"V(3,<1,2,3>) V(3,<1 -2 3, 4>) V(3,-y+z/2)",
         "<1.0000,2.0000,3.0000> <-1.0000,3.0000,4.0000> <0.0000,-1.0000,0.5000>"},
        {"V(3,(<1,5,3>>2)) V(3,!<0,1,0>) V(4,t)",
         "<0.0000,1.0000,1.0000> <1.0000,0.0000,1.0000> <0.0000,0.0000,0.0000,1.0000>"},
        {"V(3,<1,(2>1),3>) V(2,<#if (1) 5 #else 6 #end, 7>)",
         "<1.0000,1.0000,3.0000> <5.0000,7.0000>"},
        {"#declare a=<1,2,3>; P(-a.y) P((2*a).z) P(x.x)", "-2.000000 6.000000 1.000000"},
        {"P((\"a\"<\"b\")) P((\"a\"=\"a\")) P((\"ab\">\"b\"))", "1.000000 1.000000 0.000000"},
        {"P(pi) P(true) P(off) P(yes+on) P(clock) P(version)",
         "3.141593 1.000000 0.000000 2.000000 0.000000 3.700000"},
        {"#declare q=(1?1:<1,2,3>); P(q)", "1.000000"},
        {"P((#debug \"d \" #declare b=7; b+1))", "d 8.000000"},
        {"P(image_width) P(Outside)", "320.000000 42.000000"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("a wrong expression gets one message", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare a = nope; P(a) P(a + 1)", "error: nothing is declared as `nope`\n"},
        {"#declare a = 1 + \"s\";", "error: `+` cannot join a number and a string\n"},
        {"#declare a = <1, 2>.z;", "error: there is no `.z` in a vector of 2\n"},
        {"#declare a = x.hue;", "error: a vector or a colour has no part `.hue`\n"},
        {"#declare a = -\"s\";", "error: `-` takes numbers, but this is a string\n"},
        {"#declare a = (x ? 1 : 2);",
         "error: the condition of `? :` must be a number, but it is a vector of 3\n"},
        {"#declare a = <1, x>;",
         "error: a component of a vector is a number, but this is a vector of 3\n"},
        {"#declare a = <1>;", "error: a vector has 2 to 5 components, but this has 1\n"},
        {"#declare a = <1, 2, 3, 4, 5, 6>;",
         "error: a vector has 2 to 5 components, but this has 6\n"},
        {"#declare a = 1 / 0; P(a)", "warning: division by zero; the result is infinite\n"},
        {"#declare a = (1, 2);", "error: values in parentheses are no vector\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

}  // namespace candelabra
