// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/function_compiler.h"

#include "evaluate/said.h"

#include <catch2/catch.hpp>

TEST_CASE("expressions of functions have their own rules", "[evaluate]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare f=function(a){a>1} P(f(2)) #declare g=function(a,b){a!=b} P(g(1,1+1e-12))",
         "1.000000 1.000000"},
        {"#declare f=function(a,b){(a>1)&(b<2)|a=5} P(f(2,1)) P(f(5,9)) P(f(0,0))",
         "1.000000 1.000000 0.000000"},
        {"#declare f=function(a,b){a|b&0} P(f(1,0)) #declare g=function(a,b,c){a&b|c&a|0} "
         "P(g(1,0,1)) "
         "P(g(0,1,1))",
         "1.000000 1.000000 0.000000"},
        {"#declare f=function(a,b){a<b=1} P(f(1,2)) #declare g=function(a,b){a-b-1} P(g(5,2))",
         "1.000000 2.000000"},
        {"#declare f=function(a){-a+2*-a} P(f(3)) #declare g=function(a){2-a*-3} P(g(2)) #declare "
         "h=function(a){a--1} P(h(2))",
         "-9.000000 8.000000 3.000000"},
        {"#declare f=function(a){0 #for (i,1,4) + a*i #end} P(f(2)) #declare g=function(a){a #if "
         "(1) "
         "* 2 #else / 2 #end - 1 #if (0) * 5 #end} P(g(3))",
         "20.000000 5.000000"},
        {"#declare f=function(a,b,c){a/b*c} P(f(8,2,4)) #declare g=function(a,b,c){a/b/c} "
         "P(g(8,2,4))",
         "16.000000 1.000000"},
        {"#declare c=3; #declare k=function{x*c+pi+clock} P(k(1,0,0)) #declare c=100; P(k(1,0,0))",
         "6.141593 6.141593"},
        {"#declare A=array[2]{3,4} #declare f=function(a){a*A[1]} P(f(3))", "12.000000"},
        {"#declare f=function(a){1/a} P(f(0)) P(f(2)) #declare g=function(a){1/(1-1)} P(g(0))",
         "inf 0.500000 inf"},
        {"#declare f=function(a){ #if(1) a*2 #else a*3 #end } P(f(3))", "6.000000"},
        {"#declare f=function(a){ #switch (2) #case (1) a #break #case (2) a*2 #break #else 0 #end "
         "} P(f(3)) #declare g=function(a){ max(0 #for (i,1,3) , a*i #end ) } P(g(2)) #macro Two() "
         "x, 3 #end #declare h=function{ pow(Two()) } P(h(2,0,0))",
         "6.000000 6.000000 8.000000"},
        {"#declare f=function(a){ #local k=3; a*k } P(f(2)) P(k)", "6.000000 3.000000"},
        // Division by a constant multiplies by its reciprocal.
        {"#declare k=1/3; #declare f=function(a){a/k} #debug str(f(0.7),0,17)",
         "2.09999999999999964"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("what functions cannot do is reported", "[evaluate]") {
    const auto [body, message] = GENERATE(table<std::string, std::string>({
        {"a/0", "this function always divides by zero"},
        {"a/zero", "this function always divides by zero"},
        {"<1,2,3>", "a function computes with single numbers only"},
        {"\"s\"", "a function computes with single numbers only"},
        {"!a", "there is no `!` in functions; x = 0 says the same"},
        {"(a?1:2)", "there is no `? :` in functions; select(v, a, b) gives a where v < 0"},
        {"a*k", "a function computes with single numbers only, and `k` is a vector of 3"},
        {"a*k.y", "in a function, only what another function gives has parts: f(x, y, z).x"},
        {"a*true", "`true` is no parameter of this function"},
        {"a*x", "`x` is no parameter of this function"},
        {"nope", "nothing is declared as `nope`"},
        {"#if (0) 1 #end", "a function is one expression, but here is none"},
        {"#if (1) 1 2 #end", "a function is one expression, but here are 2"},
        {"#for (i, 1, 2) 1 #end", "a function is one expression, but here are 2"},
    }));
    INFO(body);
    CHECK(printed("#declare zero=0; #declare k=<1,2,3>; #declare f=function(a){" + body + "}") ==
          "error: " + message + "\n");
}
