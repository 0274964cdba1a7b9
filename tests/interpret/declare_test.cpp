// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("names are declared and hidden as in POV-Ray", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare _a=1; #declare a_1B=2; P(_a) P(a_1B)", "1.000000 2.000000"},
        {"#declare q1=1; #declare q1=<1,2,3>; #declare q1=\"s\"; #debug q1 #declare q1=sphere{0,1} "
         "P(defined(q1))",
         "s1.000000"},
        {"#declare q2=1; #undef q2 P(defined(q2))", "0.000000"},
        {"#declare q3=sphere{0,1} #declare q4=\"a\" #declare q5=array[2] #declare q6=rgb 1; P(1)",
         "1.000000"},
        {"#declare s=\"a\"; #declare s=concat(s,\"b\"); #debug s", "ab"},
        {"#local a=1; P(a)", "1.000000"},
        {"#macro A() #declare ng=4; #end A() P(ng)", "4.000000"},
        {"#macro A() #local lx=4; #declare lx=5; P(lx) #end A() P(defined(lx))",
         "5.000000 0.000000"},
        {"#declare gx=1; #macro A() #local gx=2; #declare gx=3; P(gx) #end A() P(gx)",
         "3.000000 1.000000"},
        {"#macro A(pp) #undef pp #end #declare q=1; A(q) P(defined(q))", "1.000000"},
        {"#macro A() #local w=1; B() P(w) #end #macro B() #declare w=2; #end A() P(defined(w))",
         "2.000000 0.000000"},
        {"#macro A() #local w=1; #undef w #declare w=2; #end A() P(w)", "2.000000"},
        {"#declare deprecated once \"old\" dd=1; P(1)", "1.000000"},
        {"#declare (a, b) = (1, <2, 3>); P(a) P(b.v)", "1.000000 3.000000"},
        {"#macro T(n) (n, <2, 3>) #end #declare (a, b) = T(7); P(a) P(b.v)", "7.000000 3.000000"},
        {"#macro T() #local c = 4; #if (c > 3) (c, c + 1) #end #end "
         "#macro U() #local (a, b) = T(); P(a + b) #end U() P(defined(a))",
         "9.000000 0.000000"},
        {"#macro T() (1, 2) #end #macro U() #local (a, b) = T(); (a + b, 4) #end "
         "#declare (c, d) = U(); P(c) P(d)",
         "3.000000 4.000000"},
        {"#declare A = array[2]; #declare (b, A[1],, A[0]) = (5, 6, 7, 8); P(A[0]) P(A[1]) P(b)",
         "8.000000 6.000000 5.000000"},
        {"#macro T() (1, 2, 3) #end #declare A = array[1]; #declare (, A[0],) = T(); P(A[0])",
         "2.000000"},
        {"#declare a = #if (0) 5 #else 6 #end ; P(a)", "6.000000"},
        {"#declare A = 1; #declare aa = 2; P(A) P(aa)", "1.000000 2.000000"},
        {"#declare T = texture { } texture { } P(defined(T))", "1.000000"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("a wrong declaration gets one message", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare a = 1 P(a)", "error: a `;` is missing after this value\n"},
        {"#local a = rgb 1", "error: a `;` is missing after this value\n"},
        {"#version 3.1; #local a = 1", "warning: a `;` is missing after this value\n"},
        {"#declare A=1; #macro A() #end",
         "error: `A` is declared as a number and cannot become a macro\n"},
        {"#macro A() #end #declare A=1;",
         "error: `A` is a macro and cannot become something else\n"},
        {"#undef nope", "warning: nothing is declared as `nope`\n"},
        {"#declare (a, b) = (1, 2, 3);", "error: there must be as many values as names\n"},
        {"#declare (a,, b) = (1, 2);", "error: there must be as many values as names\n"},
        {"#declare (a, A[0]) = (1, 2);", "error: there is no array `A`\n"},
        {"#macro T() (1, 2, 3) #end #declare (a, b) = T();",
         "error: there must be as many values as names\n"},
        {"#macro T() 1 #end #declare (a, b) = T();",
         "error: there must be as many values as names\n"},
        {"#macro T() (1, nope) #end #declare (a, b) = T();",
         "error: nothing is declared as `nope` (T)\n"},
        {"#macro T() (1, 2) (3, 4) #end #declare (a, b) = T();",
         "error: values in parentheses are no vector (T)\n"},
        {"#declare a = sphere;", "error: expected `{`, but found `;`\n"},
        {"#declare deprecated \"old\" a = 1; #for (i, 1, 3) #declare b = a; #end",
         "warning: old\n"},
        {"#declare deprecated a = 1; #declare b = a + a;",
         "warning: `a` is not to be used any more\nwarning: `a` is not to be used any more\n"},
        {"#declare deprecated once \"old\" a = 1; #declare b = a + a; P(b)", "warning: old\n"},
        {"#declare deprecated \"old\" a = 1; #undef a #declare a = 2; P(a)", "2.000000"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

}  // namespace candelabra
