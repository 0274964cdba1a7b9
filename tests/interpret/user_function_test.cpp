// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/said.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("functions are declared and called", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare f=function{x*y+z} P(f(2,3,4)) #declare g=function(a,b){a-b} P(g(5,2))",
         "10.000000 3.000000"},
        {"#declare f=function{u+v} P(f(2,3,4)) #declare g=function(u,v){u-v} P(g(2,3))",
         "5.000000 -1.000000"},
        {"#macro A(f) P(f(3,0,0)) #end #declare q=function{x+1} A(q) A(function{x*7})",
         "4.000000 21.000000"},
        {"#declare q=function{x+1} #declare q2=q; P(q2(1,2,3))", "2.000000"},
        {"#declare A=array[2] #declare A[0]=function{x*10} #declare A[1]=function{x*20} "
         "P(A[1](2,0,0))",
         "40.000000"},
        {"#declare A=array[2]{function{x},function{y}} P(A[1](1,2,3))", "2.000000"},
        {"#declare f=function{x} #undef f #declare f=function{y} P(f(1,2,3))", "2.000000"},
        {"#declare f=function{x} P(f(<1,2,3>.x,2,3)) P(f(1 2 3)) V(2,<f(4,0,0),f(5,0,0)>)",
         "1.000000 1.000000 <4.0000,5.0000>"},
        {"#declare f=function{internal(57)} P(f(1,2,2)) #declare s=function{internal(61)} "
         "P(s(1,2,2,1))",
         "3.000000 2.000000"},
        {"#macro M() #local f=function{x*2} P(f(1,0,0)) #end M() M()", "2.000000 2.000000"},
        {"#declare s=0; #declare f=function(a){a*a} #for(i,1,4) #declare s=s+f(i); #end P(s)",
         "30.000000"},
        // The function that a name stands for may change between two passes.
        {"#declare f=function(a){a} #declare s=0; #for(i,1,6) #declare s=s+f(1); #if(i=3) #undef f "
         "#declare f=function(a){10*a} #end #end P(s)",
         "33.000000"},
        {"#declare f=function{x} P(defined(f)) #ifdef(f) P(1) #end", "1.000000 1.000000"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("splines in functions are vectors of one number", "[interpret]") {
    CHECK(printed("#declare sp=function{spline{0,<1,2,3> 1,<4,5,6>}} V(3,sp(.5)) V(3,sp(.5)*2) "
                  "P(sp(.5).y) #declare g=function{sp(x).y} P(g(.5,0,0))") ==
          "<2.5000,3.5000,4.5000> <5.0000,7.0000,9.0000> 3.500000 3.500000");
}

TEST_CASE("a wrong function is reported once", "[interpret]") {
    const auto [script, message] = GENERATE(table<std::string, std::string>({
        {"#declare f=function{x} P(f(1))", "function `f` takes 3 arguments, but here is 1"},
        {"#declare f=function(a){a} P(f(1,2))", "function `f` takes 1 argument, but here are 2"},
        {"#declare f=function{x} P(f(1,2,\"a\"))", "`f` takes numbers, but this is a string"},
        {"#declare f=function{x} P(f(1,2,y))", "`f` takes numbers, but this is a vector of 3"},
        {"#declare a=5; #declare f=function(a){a}",
         "`a` is declared already; a parameter needs a name of its own"},
        {"#declare f=function(a,a){a}", "there are two parameters `a`"},
        {"#declare f=function(){1}", "a function has 1 to 56 parameters, but here are 0"},
        {"#declare f=function(t){1}", "a parameter is a name"},
        {"#declare f=function(a+1){1}", "a parameter is a name"},
        {"#declare f=function{x} #declare f=function{y}",
         "`f` is a function and cannot become something else"},
        {"#declare f=function{x} #declare f=1;",
         "`f` is a function and cannot become something else"},
        {"#declare f=function{internal(99)}", "there is no internal function 99"},
        {"#declare f=function{internal(1.5)}", "there is no internal function 1.5"},
        {"#declare f=function{internal(1e300)}", "there is no internal function 1e+300"},
        {"#declare f=function(a){pigment{rgb 1}}",
         "a function of this kind has the parameters that it has; leave these out"},
        {"#declare f=function 3,4,5 {x}",
         "a picture made by a function has a width and a height from 1 to 16384"},
        {"#declare f=function{sphere{0,1}}",
         "a function is an expression, or one of transform, spline, pattern, pigment, internal"},
        {"#declare A=array[1]{1} P(A[0](1))", "this is a number and cannot be called"},
        {"#declare f=function(a){sum(i,1,1e300,i)} P(f(1))",
         "`f` gives no value here: a sum in it does not end"},
    }));
    INFO(script);
    CHECK(printed(script) == "error: " + message + "\n");
}

TEST_CASE("functions that call functions have a limit", "[interpret]") {
    CHECK(printed("#declare A = array[150] #declare A[0] = function(a) { a } #for (i, 1, 98) "
                  "#local f = A[i - 1]; #declare A[i] = function(a) { f(a) + 1 } #undef f #end "
                  "P(A[98](0))") == "98.000000");
    CHECK(printed("#declare A = array[150] #declare A[0] = function(a) { a } #for (i, 1, 120) "
                  "#local f = A[i - 1]; #declare A[i] = function(a) { f(a) + 1 } #undef f #end")
              .substr(0, 61) == "error: functions call each other more than 100 deep, which is");
}

TEST_CASE("a macro may give the pattern or pigment of a function", "[interpret]") {
    const auto [body, result] = GENERATE(table<std::string, std::string>({
        {"P()", "1.0 0.0"},
        {"#if (1) P() #else pigment { rgb 1 } #end", "1.0 0.0"},
        {"#local C = x; pigment { rgb C }", "1.0 0.0"},
        {"Q(<1, 0, 0.5>)", "1.0 0.0"},
        {"#switch (2) #case (1) pigment { rgb 1 } #break #case (2) Q(x) #break #end", "1.0 0.0"},
    }));
    INFO(body);
    const Evaluated done = evaluated(
        "#version 3.7; #macro P() pigment { checker rgb x rgb y scale 3 } #end "
        "#macro Q(C) pigment { rgb C } #end #declare F = function { " +
        body + " } #debug concat(str(F(1, 1, 1).red, 0, 1), \" \", str(F(1, 1, 1).green, 0, 1))");
    INFO(done.diagnostics);
    CHECK(done.printed == result);
}

TEST_CASE("elements of arrays and macros may give transformations to functions", "[interpret]") {
    const Evaluated done = evaluated(
        "#version 3.7; #declare F = array[1] { function { transform { translate <1, 2, 3> } } } "
        "#declare G = function { F[0](x, y, z).y } #macro T() transform { translate x } #end "
        "#declare H = function { T() } #debug concat(str(G(0, 5, 0), 0, 1), str(H(2, 0, 0).x, 0, "
        "1))");
    INFO(done.diagnostics);
    CHECK(done.printed == "7.03.0");
    CHECK(
        evaluated("#version 3.7; #declare A = array[1] { 3 } #declare F = function(a) { A[0](a) }")
            .diagnostics.find("this element is no function") != std::string::npos);
}

TEST_CASE("a pattern has a meaning in functions only", "[interpret]") {
    CHECK(evaluated("#version 3.7; #declare P = pattern { bozo }").failed);
}

TEST_CASE("the noise of a pattern function is the scene's", "[interpret]") {
    const auto value = [](const std::string& settings, const std::string& pattern) {
        const Evaluated result = evaluated("#version 3.7; global_settings { " + settings +
                                           " } #declare f = function { pattern { " + pattern +
                                           " } } #debug str(f(.31, .42, -.57), 0, 6)");
        INFO(result.diagnostics);
        CHECK_FALSE(result.failed);
        return result.printed;
    };
    CHECK(value("noise_generator 2", "bozo") == value("", "bozo"));
    CHECK(value("noise_generator 1", "bozo") != value("", "bozo"));
    CHECK(value("noise_generator 1", "bozo") == value("", "bozo noise_generator 1"));
    const auto grey = [&](const std::string& settings) {
        return value(settings, "pigment_pattern { bozo color_map { [0 rgb 0] [1 rgb 1] } }");
    };
    CHECK(grey("noise_generator 1") != grey(""));
}

TEST_CASE("the noise of a function is what the scene says when it is called", "[interpret]") {
    const std::string function = "#version 3.7; #declare f = function { internal(76) } ";
    const std::string print = "#debug str(f(.3, .7, .2), 0, 6) ";
    const auto [script, result] = GENERATE_COPY(table<std::string, std::string>({
        {print, "0.419692"},
        {"#version 3.1; " + print + "#version 3.5; " + print, "0.3043460.419692"},
        {"global_settings { noise_generator 1 } " + print, "0.304346"},
        {"#version 3.1; global_settings { noise_generator 2 } " + print, "0.419692"},
    }));
    CHECK(evaluated(function + script).printed == result);
}

}  // namespace candelabra
