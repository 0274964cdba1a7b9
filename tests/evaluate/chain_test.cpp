// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/chain.h"

#include "evaluate/said.h"

#include <catch2/catch.hpp>

TEST_CASE("a directive goes on with an expression", "[evaluate]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare a=1 #if (1) + 2 #end; P(a)", "3.000000"},
        {"#declare a=1 #if (0) + 2 #end; P(a)", "1.000000"},
        {"#declare a=1 #if (1) + 2 #end * 3; P(a)", "7.000000"},
        {"#declare a=1 #if (0) + 2 #end * 3; P(a)", "3.000000"},
        {"P((4 - 2 #if (1) * 3 #else / 2 #end + 1)) P((2 * -3 #if (1) - 1 #end))",
         "-1.000000 -7.000000"},
        {"P((9 #if (1) - 3 - 2 #if (1) * 4 #end #end / 2))", "2.000000"},
        {"P((1 #if (1) + 2 #end #ifdef (q) + 5 #else - 4 #end #if (1) * 3 #end))", "-9.000000"},
        {"P((0 #for (i, 1, 4) + i #end)) #declare i=0; P((1 #while (i<3) #declare i=i+1; * i "
         "#end))",
         "10.000000 6.000000"},
        {"#declare a=2; P((1 #switch (a) #case (1) + 1 #break #case (2) + 5 #break #else * 9 "
         "#end))",
         "6.000000"},
        {"V(3,<1, 2 #if (1) + 5 #end, 3>) V(3,<1,2,3> #if (1) * 2 #end) V(3,<#for (i,4,6) i, "
         "#end>)",
         "<1.0000,7.0000,3.0000> <2.0000,4.0000,6.0000> <4.0000,5.0000,6.0000>"},
        {"P(max(1 #if (1) + 4 #end, 2)) P(max(0 #for (i,1,4) , i #end)) "
         "P(max(0, #for (i,1,3) i, #end 2)) P(abs(1 #if (1) - 4 #end))",
         "5.000000 4.000000 3.000000 3.000000"},
        {"#declare A=array[3]{1 #if (1) + 1 #end,2,3} P(A[0]) P(A[1 #if (1) + 1 #end]) "
         "P(A[#if (0) 0 #else 1 #end])",
         "2.000000 3.000000 2.000000"},
        {"#if (0 #if (1) + 1 #end) P(1) #end #for (i, 1, 2 #if (1) + 1 #end) P(i) #end",
         "1.000000 1.000000 2.000000 3.000000"},
        {"#declare c=rgb #if (1) <1,2,3> #else 0 #end; V(3,c) #debug #if (1) \"b\" #else \"c\" "
         "#end",
         "<1.0000,2.0000,3.0000> b"},
        // Elements of a list, each with its own sign.
        {"#declare A=array[3]{1, #if (1) -2, #end #if (1) -3 #end} P(A[1]) P(A[2])",
         "-2.000000 -3.000000"},
        {"P((3 #if (0) * 5 #end)) P((3 #if (1) - 1 #if (0) * 5 #else * 2 #end #end))",
         "3.000000 1.000000"},
        {"P((1 #if (1) + 2 5 #end))",
         "error: there is no operator between this and the expression before it\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}
