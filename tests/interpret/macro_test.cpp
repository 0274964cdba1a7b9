// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/macro.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("arguments go by reference or by value", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#macro A(p) #declare p = p + 1; #end #declare q = array[2] {1, 5}; A(q[1]) P(q[1]) "
         "P(q[0])",
         "6.000000 1.000000"},
        {"#macro A(p) #declare q[1] = 9; P(p) #end #declare q = array[2] {1, 5}; A(q[1])",
         "9.000000"},
        {"#macro A(p) #declare p = 7; P(q[1]) #end #declare q = array[2] {1, 5}; A(q[1])",
         "7.000000"},
        {"#macro A(p) B(p) #end #macro B(r) #declare r = 8; #end #declare q = array[1] {1}; "
         "A(q[0]) "
         "P(q[0])",
         "8.000000"},
        {"#macro A(p) #declare p = 3; #end #declare q = array[1] {1}; #declare s = q; A(q[0]) "
         "P(q[0]) "
         "P(s[0])",
         "3.000000 1.000000"},
        {"#macro A(p) #declare p[0] = 4; #end #declare q = array[1] {array[1] {1}}; A(q[0]) "
         "P(q[0][0])",
         "4.000000"},
        {"#macro A(p) #undef p P(defined(p)) #end #declare q = array[1] {1}; A(q[0]) P(q[0])",
         "0.000000 1.000000"},
        {"#macro A(p, r) #declare p = 1; P(r) #end #declare q = array[1] {5}; A(q[0], q[0])",
         "1.000000"},
        {"#macro A(p) #local p = p * 2; P(p) #end A(3 + 1) A(<1, 2, 3>.y)", "8.000000 4.000000"},
        {"#macro A(n) #if (n > 0) A(n - 1) P(n) #end #end A(3)", "1.000000 2.000000 3.000000"},
        {"#macro A(a, b) P(a - b) #end #macro B(a, b) A(b, a) #end B(1, 3)", "2.000000"},
        {"#macro M(A, optional B, optional C) #local Z = A; #ifdef(local.B) #debug \"B\" #else "
         "#debug \"b\" #end "
         "#ifdef(local.C) #debug \"C \" #else #debug \"c \" #end #end "
         "#declare B = 9; M(1,2,3) M(1,,3) M(1,2,) M(1,,) M(1,U,) M(1)",
         "BC bC Bc bc bc bc"},
        {"#macro M(optional A) P(defined(A)) #end #declare R = array[2]; M(R[0]) #declare R[1] = "
         "3; "
         "M(R[1])",
         "0.000000 1.000000"},
        {"#macro N(optional A) M(A, 2) #end #macro M(optional A, B) P(defined(A)) P(B) #end N() "
         "N(5)",
         "0.000000 2.000000 1.000000 2.000000"},
        {"#declare F=1; #macro Q() #local F=2; P(local.F) P(global.F) #declare global.F=3; "
         "#declare global.N=5; #end Q() P(F) P(N)",
         "2.000000 1.000000 3.000000 5.000000"},
        {"#declare F=1; #macro Q(F) #declare local.F=2; P(F) P(global[\"F\"]) #undef global.F "
         "P(defined(global.F)) P(defined(F)) #end Q(7) P(defined(F))",
         "2.000000 1.000000 0.000000 1.000000 0.000000"},
        {"#declare A=array[2]{1,2} #macro Q() #local A=5; P(global.A[1]) #declare global.A[0]=8; "
         "#end Q() P(A[0])",
         "2.000000 8.000000"},
        {"#declare global=<1,2,3>; P(global.y)", "2.000000"},
        {"#declare global.A=4; P(A) P(local.A)", "4.000000 4.000000"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("a macro may define another, or itself, while it runs", "[interpret]") {
    CHECK(printed("#macro A() #macro A() P(2) #end P(1) #end A() A()") == "1.000000 2.000000");
    CHECK(
        printed("#macro D(n) #if (n = 1) #macro X() P(1) #end #else #macro X() P(2) #end #end #end "
                "#for (i, 1, 3) D(i) X() #end") == "1.000000 2.000000 2.000000");
}

TEST_CASE("arguments that failed leave nothing behind", "[interpret]") {
    CHECK(printed("#macro A(a, b) #end A(1 + 1, nope) A(1 + 2, 1, 2)") ==
          "error: nothing is declared as `nope`\n"
          "error: macro `A` takes 2 arguments, but here are 3\n");
}

}  // namespace candelabra
