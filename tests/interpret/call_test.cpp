// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("macros behave as POV-Ray's", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#macro Two() 3,7 #end P(max(Two())) P(pow(Two())) V(3,<Two(),1>) "
         "#macro A(p,q) P(p*10+q) #end A(Two())",
         "7.000000 2187.000000 <3.0000,7.0000,1.0000> 37.000000"},
        {"#macro F(n) #if(n<=1) #local R=1; #else #local R=n*F(n-1); #end R #end P(F(6)) #declare "
         "z1=F(5); P(z1)",
         "720.000000 120.000000"},
        {"#macro M3(a) V(3,a) #end M3(<1,2,3>) M3(x+y) M3(2*z)",
         "<1.0000,2.0000,3.0000> <1.0000,1.0000,0.0000> <0.0000,0.0000,2.0000>"},
        {"#macro M4(s) #debug s #end M4(\"abc\") M4(concat(\"a\",\"b\"))", "abcab"},
        {"#macro M5(a b) P(a) P(b) #end M5(1 2) M5(1,2) M5(1 -2,5)",
         "1.000000 2.000000 1.000000 2.000000 -1.000000 5.000000"},
        {"#macro A() P(1) #end #macro A() P(2) #end A()", "2.000000"},
        {"#macro A() #macro BB() P(3) #end #end A() BB()", "3.000000"},
        {"#macro A(a) a+1 #end P(A(A(A(1))))", "4.000000"},
        {"#macro A() P(1) #break P(2) #end A() P(3)", "1.000000 3.000000"},
        {"#macro A(p) #declare p = p + 1; #end #declare q = 1; A(q) P(q) A((q)) P(q) A(q + 0) P(q)",
         "2.000000 2.000000 2.000000"},
        {"#macro A(p) #local p = 5; #end #declare q = 1; A(q) P(q)", "5.000000"},
        {"#macro A(p, q) P(p) P(q) #end #macro B(q, p) A(q, p) #end B(1, 2)", "1.000000 2.000000"},
        {"#macro C() 1, 2 #end V(3, <C(), 3>)", "<1.0000,2.0000,3.0000>"},
        {"#macro A(a, optional b) #ifdef (b) P(b) #else P(a) #end #end A(1) A(1, 2)",
         "1.000000 2.000000"},
        {"#macro A() #local w = 1; B() #end #macro B() P(w) #end A()", "1.000000"},
        {"#macro G(n) #if(n<=1) 1 #else n*2 #end #end P(max(G(1),G(4))) V(2, <G(2), G(3)>)",
         "8.000000 <4.0000,6.0000>"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("a wrong call gets one message", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#macro A(a,b) #end A(1)", "error: macro `A` takes 2 arguments, but here is 1\n"},
        {"#macro A(a) #end A(1,2)", "error: macro `A` takes 1 argument, but here are 2\n"},
        {"#macro A(a, optional b) #end A()",
         "error: macro `A` takes 1 to 2 arguments, but here are 0\n"},
        {"#macro A() #end A", "error: `A` is a macro: its call needs parentheses\n"},
        {"#macro M(a) #end M(nope)", "error: nothing is declared as `nope`\n"},
        {"nope(1)", "error: nothing is declared as `nope`\n"},
        {"#declare a = 1; a(1)", "error: `a` is a number and cannot be called\n"},
        {"#macro A() #end #declare a = A();",
         "error: a value is wanted here, and this macro gives none\n"},
        {"#macro A() 1, 2 #end #declare a = A();",
         "error: one value is wanted here, and this gives 2\n"},
        {"#macro A() open #end #declare a = A();",
         "error: a value is wanted here, and `open` is none\n"},
        {"#macro A() B() #end #macro B() #declare b = nope; #end A()",
         "error: nothing is declared as `nope` (B) (A)\n"},
        {"#declare a = sin(1, 2);", "error: `sin` takes 1 argument, but here are 2\n"},
        {"#declare a = sin();", "error: `sin` takes 1 argument, but here are 0\n"},
        {"#declare a = max();", "error: `max` takes at least 1 argument, but here are 0\n"},
        {"#declare a = select(1, 2);", "error: `select` takes 3 or 4 arguments, but here are 2\n"},
        {"#declare a = sin(x);",
         "error: the argument of `sin` must be a number, but it is a vector of 3\n"},
        {"#declare a = vlength(\"s\");",
         "error: `vlength` takes numbers here, but this is a string\n"},
        {"#declare a = trace(1, 2, 3);",
         "error: `trace` takes a declared object here, but this is a number\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("recursion is as deep as it needs to be", "[interpret]") {
    CHECK(printed("#macro R(n) #if (n > 0) R(n - 1) #else P(1) #end #end R(100000)") == "1.000000");
    CHECK(printed("#macro S(n) #if (n > 0) #local r = n + S(n - 1); #else #local r = 0; #end r "
                  "#end P(S(10000))") == "50005000.000000");
}

TEST_CASE("recursion without end is an error", "[interpret]") {
    CHECK(said("#macro R() R() #end R()").messages ==
          "error: macros call each other 200000 deep, which is the limit\n");
    CHECK(said("#macro R() 1 + R() #end #declare a = R();").messages ==
          "error: macros call each other 200000 deep, which is the limit\n");
    Limits limits;
    limits.stack_bytes = std::size_t{1} << 23;
    CHECK(said("#macro R() (1 + (1 + (1 + R()))) #end #declare a = R();", {}, limits).messages ==
          "error: this is nested too deeply\n");
}

}  // namespace candelabra
