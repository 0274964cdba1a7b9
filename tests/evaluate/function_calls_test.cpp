// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/function_compiler.h"

#include "evaluate/said.h"

#include <catch2/catch.hpp>

TEST_CASE("functions call functions", "[evaluate]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare n=function(a){a*2} #declare f=function{n(x)+n(y)} P(f(1,2,3))", "6.000000"},
        {"#declare f=function(a){min(a,1,2)+max(1,a)+mod(a,2)+div(7,a)+int(a)} P(f(2.5))",
         "8.000000"},
        {"#declare f=function(a){select(a,1,2)} P(f(-1)) P(f(0)) #declare "
         "g=function(a){select(a,1,2,3)} P(g(-1)) P(g(0)) P(g(1))",
         "1.000000 2.000000 1.000000 2.000000 3.000000"},
        {"#declare f=function(a){pow(a,0)+a} P(f(0)) #declare g=function(a){-pow(a,2)} P(g(3))",
         "1.000000 -9.000000"},
        {"#declare f=function(a){pow(a,7)} #debug str(f(1.1),0,17)", "1.94871710000000098"},
        {"#declare f=function(a){pow(a,6)} #debug str(f(1.1),0,17)", "1.77156100000000083"},
        {"#declare f=function(a){pow(a,2.5)+atan2(a,1)} P(f(1))", "1.785398"},
        {"#declare s=function(n){sum(i,1,n,i*i)} P(s(4)) P(s(0)) P(s(2.5))",
         "30.000000 0.000000 5.000000"},
        {"#declare p=function(n){prod(i,1,n,i)} P(p(5)) P(p(0))", "120.000000 1.000000"},
        {"#declare s=function(n,m){sum(i,1,n,sum(j,1,m,i*j))} P(s(2,3))", "18.000000"},
        {"#declare s=function(n){sum(i,1,n,sum(j,i,n,i-j*i+i*i*i))} P(s(4))", "101.000000"},
        {"#declare s=function(a){sum(a,1,3,a)} P(s(2))", "6.000000"},
        {"#macro MC() 3*x #end #declare f=function{MC()+1} P(f(2,0,0))", "7.000000"},
        {"#macro MC(q) #local k=q; k*x #end #declare f=function{MC(4)} P(f(2,0,0)) P(defined(k))",
         "8.000000 0.000000"},
        {"#declare s=function{spline{0,<1,2,3> 1,<4,5,6>}} #declare "
         "f=function{s(x).x+10*s(y).z+s(1).gray+s(0).hf} P(f(0,1,2))",
         "66.820905"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("a wrong call in a function is reported", "[evaluate]") {
    const auto [body, message] = GENERATE(table<std::string, std::string>({
        {"rand(1)", "`rand` cannot be used in functions"},
        {"vlength(a)", "`vlength` cannot be used in functions"},
        {"a+strlen(\"x\")", "`strlen` cannot be used in functions"},
        {"min(a)", "in a function, `min` takes at least 2 arguments, but here is 1"},
        {"sin(a,a)", "in a function, `sin` takes 1 argument, but here are 2"},
        {"pow(a)", "in a function, `pow` takes 2 arguments, but here is 1"},
        {"select(a,1)", "in a function, `select` takes 3 or 4 arguments, but here are 2"},
        {"n(a,a)", "function `n` takes 1 argument, but here are 2"},
        {"s(a)", "`s` gives a vector of 2, of which a function uses one part: s(...).x"},
        {"s(a).z", "there is no `.z` in the 2 numbers of `s`"},
        {"s(a).gray", "there is no `.gray` in the 2 numbers of `s`"},
        {"sum(k,1,2,k)", "`sum` counts with a name that stands for nothing else"},
        {"sum(i,1,2)", "`sum` counts with a name that stands for nothing else"},
        {"M(a)", "nothing is declared as `a`"},
        {"k(a)", "a function computes with single numbers only, and `k` is a vector of 3"},
    }));
    INFO(body);
    const std::string messages =
        said(
            "#macro M(q) q*2 #end #declare k=<1,2,3>; #declare n=function(a){a} #declare "
            "s=function{spline{0,<1,2> 1,<4,5>}} #declare f=function(a){" +
            body + "}")
            .messages;
    CHECK(messages == "error: " + message + "\n");
}
