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
