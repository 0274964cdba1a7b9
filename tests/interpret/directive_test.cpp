// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("directives behave as POV-Ray's", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#if (1e-10) P(1) #else P(2) #end #if (1.1e-10) P(1) #end", "2.000000 1.000000"},
        {"#if (0) P(1) #elseif (1) P(2) #else P(3) #end", "2.000000"},
        {"#ifdef (sphere) P(1) #else P(0) #end #ifndef (a) P(2) #end", "0.000000 2.000000"},
        {"#declare i = 0; #while (i < 3) P(i) #declare i = i + 1; #end",
         "0.000000 1.000000 2.000000"},
        {"#while (1) #break #end P(1)", "1.000000"},
        {"#for (i, 0, 1, .1) #end P(i)", "1.100000"},
        {"#for (i, 3, 1, -1) P(i) #end P(i)", "3.000000 2.000000 1.000000 0.000000"},
        {"#for (i, 2, 1) P(i) #end P(i)", "2.000000"},
        {"#declare n = 1e999 * 0; #for (i, 0, 1, n) P(i) #end #for (i, 1, 0, n) P(i) #end", ""},
        {"#for (i, 1+1, 2*2) P(i) #end", "2.000000 3.000000 4.000000"},
        {"#for (i, 1, 9) P(i) #if (i = 2) #break #end #end P(i)", "1.000000 2.000000 2.000000"},
        {"#for (i, 1, 5) P(i) #declare i = i + 1; #end", "1.000000 3.000000 5.000000"},
        {"#declare i=\"s\"; #for(i,1,2) P(i) #end", "1.000000 2.000000"},
        {"#declare i=100; #macro A() #for(i,1,2) P(i) #end #end A() P(i)",
         "1.000000 2.000000 100.000000"},
        {"#switch (2) #case (1) P(1) #case (2) P(2) #case (3) P(3) #break #else P(4) #end",
         "2.000000 3.000000"},
        {"#switch (2.5) #case (2) P(1) #range (2, 3) P(2) #end", "2.000000"},
        {"#switch (9) #case (2) P(1) #else P(2) #end", "2.000000"},
        {"#switch (1) P(1) #case (1) #end", "1.000000"},
        {"#render \"r\\n\" #statistics \"s\\n\" #debug \"d\"", "r\ns\nd"},
        {"#declare vv1=version; #version 3.5; P(version) #version vv1; P(version)",
         "3.500000 3.700000"},
        {"#version 3.6+0.1; P(version) #version unofficial 3.7; P(1)", "3.700000 1.000000"},
        {"#default { finish { ambient 0 } } P(1)", "1.000000"},
        // What follows a #break in its part, and a part that is not taken, is not read.
        {"#macro M(K) #switch (K) #case (1) P(1) #break #default: ] } #break #end #end M(1)",
         "1.000000"},
        {"#switch (2) #case (1) sphere { ( } #foo #break #case (2) P(2) #end", "2.000000"},
        {"#for (I, 1, 3) P(I) #break } ] ~ #if (1) { #end #end P(9)", "1.000000 9.000000"},
        {"P(tau) #macro M(tau) P(tau) #end M(2) #declare tau = 3; P(tau)",
         "6.283185 2.000000 3.000000"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("the first #version asks for what there is", "[interpret]") {
    const auto answer = [](const std::string& script) {
        const Said result = said(script);
        return result.printed + result.messages;
    };
    CHECK(answer("#version version; #debug str(version, 0, 1)") == "3.8");
    CHECK(answer("#debug str(version, 0, 1)") == "3.7");
    CHECK(answer("#version 3.5; #version version; #debug str(version, 0, 1)") == "3.5");
    CHECK(answer("#declare A = 1; #version 3.8;") ==
          "error: `#version 3.8` must be the first statement of the scene: what stands before it "
          "would be read by the rules of an older version\n");
    CHECK(answer("#version 3.7; #declare A = 1; #version 3.8; #debug \"fine\"") == "fine");
    CHECK(answer("/* a comment */ #version 3.8; #debug \"fine\"") == "fine");
    CHECK(answer("#version 3.71;") ==
          "warning: `#version 3.71` was a name of versions on the way to 3.8; the scene is read by "
          "the rules of 3.7\n");
    const std::map<std::string, std::string> files = {{"a.inc", "A #version 3.8; P"}};
    CHECK(said("#include \"a.inc\"", files).messages.empty());
}

TEST_CASE("from 3.8 on the names of files have escapes", "[interpret]") {
    const std::map<std::string, std::string> files = {{"ta.inc", "#debug \"found\""},
                                                      {"t\\u0061.inc", "#debug \"literal\""}};
    const std::string include = "#include \"t\\u0061.inc\"";
    CHECK(said("#version 3.8; " + include, files).printed == "found");
    CHECK(said("#version 3.7; " + include, files).printed == "literal");
}

TEST_CASE("a wrong directive gets one message", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#if (x) #end", "error: a condition must be a number, but it is a vector of 3\n"},
        {"#for (i, 1, 2, 0) #end", "error: the step of this #for is 0, so it would not end\n"},
        {"#for (i, 1) #end", "error: a #for needs a name, a start and an end: #for(i, 1, 10)\n"},
        {"#declare A=array[1]{1} #for(A[0],1,2) #end", "error: a #for counts with a plain name\n"},
        {"#for (i, 1, 2) #declare i = \"s\" #end",
         "error: the counter `i` is no number any more\n"},
        {"#break", "error: this #break is in no loop, #switch or macro that it could leave\n"},
        {"#error \"boom\\n\" P(1)", "error: boom\n"},
        {"#warning \"careful\\n\"", "warning: careful\n"},
        {"#debug 1", "error: a message is a string, but this is a number\n"},
        {"#version 9;", "error: the language has versions 1 to 3.8, but this is 9\n"},
        {"#include \"nosuch.inc\" P(nope)", "error: there is no file `nosuch.inc`\n"},
        {"#include 1", "error: #include takes the name of a file, but this is a number\n"},
        {"#fopen F \"a\" write", "error: a scene may not write `a`\n"},
        {"#fclose P", "error: `P` is a macro and not an open file\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("files are included, each in a scope of its own", "[interpret]") {
    const std::map<std::string, std::string> files = {
        {"a.inc",
         "#local hidden = 1; #declare seen = 2; #declare T = hidden + 1; #macro M() seen #end box "
         "{ }"},
        {"self.inc", "#include \"self.inc\""},
        {"bad.inc", "#declare a = ;"},
        {"wrong.inc", "#declare a = nope;"},
        {"value.inc", "3 * 2"},
    };
    CHECK(said(prelude + "#include \"a.inc\" P(T) P(defined(hidden)) P(M()) #include \"a\" P(seen)",
               files)
              .printed == "2.000000 0.000000 2.000000 2.000000 ");
    CHECK(said("sphere { } #include \"a.inc\"", files).elements == "block sphere, block box");
    CHECK(said(prelude + "#declare a = #include \"value.inc\"; P(a)", files).printed ==
          "6.000000 ");
    CHECK(said("#include \"self.inc\"", files).messages ==
          "error: files include each other 100 deep, which is the limit\n");
    CHECK(said("#include \"bad.inc\" #declare b = nope;", files).messages ==
          "error: expected a value, but found `;` (bad.inc)\n");
    CHECK(said("#macro M() #include \"wrong.inc\" #end M()", files).messages ==
          "error: nothing is declared as `nope` (wrong.inc) (M)\n");
}

TEST_CASE("a loop without end is an error", "[interpret]") {
    Limits limits;
    limits.steps = 1000;
    CHECK(said("#while (1) #end", {}, limits).messages ==
          "error: this scene takes more than 1000 passes of loops and calls of macros, which is "
          "the limit\n");
    CHECK(said("#for (i, 0, 1) #declare i = 0; #end", {}, limits).messages ==
          "error: this scene takes more than 1000 passes of loops and calls of macros, which is "
          "the limit\n");
    CHECK(said("#for (i, 1, 1000) #end", {}, limits).messages == "");
    CHECK(said("#macro M(n) #if (n > 0) M(n - 1) M(n - 1) #end #end M(60)", {}, limits).messages !=
          "");
}

}  // namespace candelabra
