// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/function_compiler.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("expressions of functions have their own rules", "[interpret]") {
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
        {"#declare F = array[2]; #declare F[1] = function(a, b) { a*b } "
         "#declare g = function(x, y) { F[1](x, y) + 1 } P(g(0.5, 4))",
         "3.000000"},
        {"#declare F = array[2] { function(a) { a + 1 }, function(a) { 2*a } } "
         "#macro Use(I) F[I](a) #end #declare g = function(a) { Use(1) - F[0](a) } P(g(5))",
         "4.000000"},
        {"#macro S() #local K = 1; spline { linear_spline 0, <0, 0> K, <2, 4> } #end "
         "#declare f = function { #if (1) S() #else x #end } P(f(0.5).y)",
         "2.000000"},
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

TEST_CASE("what functions cannot do is reported", "[interpret]") {
    const auto [body, message] = GENERATE(table<std::string, std::string>({
        {"a/0", "this function always divides by zero"},
        {"a/zero", "this function always divides by zero"},
        {"<1,2,3>", "a function computes with single numbers only"},
        {"\"s\"", "a function computes with single numbers only"},
        {"!a", "there is no `!` in functions; x = 0 does the same"},
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

TEST_CASE("functions call functions", "[interpret]") {
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

TEST_CASE("a wrong call in a function is reported", "[interpret]") {
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

}  // namespace candelabra
