// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/chain.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a directive goes on with an expression", "[interpret]") {
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

TEST_CASE("a part of a condition ends in an operator", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare a=#if (1) -1* #end 5; P(a) #declare a=#if (0) -1* #end 5; P(a)",
         "-5.000000 5.000000"},
        {"P((1 + #if (1) 2 * #else 3 + #end 4 * 5)) P((1 + #if (0) 2 * #else 3 + #end 4 * 5))",
         "41.000000 24.000000"},
        {"P((1 #if (1) + 2 * #end 3 - 1)) P((#if (1) - #end 3))", "6.000000 -3.000000"},
        {"P((#if (1) 2 * #if (1) 3 * #end #end 4)) P((#if (1) 2 * #end #if (0) 3 #else 5 #end))",
         "24.000000 10.000000"},
        {"V(3,<#if (1) 2* #end 1, #if (0) 2* #end 1, 3>) P(max(1, #if (1) 7* #end 2))",
         "<2.0000,1.0000,3.0000> 14.000000"},
        {"#declare F=function(x) { x + #if (1) x* #end 3 } P(F(2))", "8.000000"},
        {"P((2 * #if (1) 1 + 2 #else 3 #end))", "4.000000"},
        {"#if (1) #declare a=1 + #end 2", "error: an operator in this has no value behind it\n"},
        {"P((1 + #if (0) 2 #end))", "error: an operator in this has no value behind it\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("a macro among operands stands for its text", "[interpret]") {
    const std::string macros =
        "#macro Sum(A,B) A+B #end #macro Neg() -1 #end #macro None() #end #macro Two() 3,7 #end "
        "#macro If(A) #if (A) A+1 #else A-1 #end #end ";
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"P(2*Sum(1,2)*3) P(10-Sum(1,2)) P(-Sum(1,2)) P(12/Sum(2,4))",
         "8.000000 11.000000 1.000000 10.000000"},
        {"P(2*(Sum(1,2))) P(Sum(1,2)*Sum(3,4)) P(3-Neg()) P(2*If(1)) P(2*If(0))",
         "6.000000 11.000000 4.000000 3.000000 -1.000000"},
        {"#macro Sums() Sum(1,2)+Sum(3,4) #end P(2*Sums()*2)", "15.000000"},
        {"V(3,<2*Sum(1,2), 0, -Sum(1,2)>) P(+Sum(1,2)) P(max(2*Sum(1,2), 0))",
         "<4.0000,0.0000,1.0000> 3.000000 4.000000"},
        {"#macro XY() x+y #end #declare F=function { 2*XY() - XY() } P(F(3,5,0))", "13.000000"},
        {"P(1+None())", "error: a value is wanted here, and this macro gives none\n"},
        {"P(1+Two())", "error: one value is wanted here, and this gives 2\n"},
        {"P(1+Sum(1))", "error: macro `Sum` takes 2 arguments, but here is 1\n"},
        {"#declare F=function { Sum(1) } ",
         "error: macro `Sum` takes 2 arguments, but here is 1\n"},
        {"P(1+Sum(\"a\",2))", "error: `+` cannot join a number and a string (Sum)\n"},
    }));
    INFO(script);
    CHECK(printed(macros + script) == result);
}

}  // namespace candelabra
