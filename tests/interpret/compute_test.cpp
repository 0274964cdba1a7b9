// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions are computed the same way whether they are walked (the first time) or run as programs
// (from the second time on).
#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a name may stand for something else each time", "[interpret]") {
    CHECK(printed("#declare A = array[5] {1, <1, 2>, <1, 2, 3>, <1, 2, 3, 4>, rgb 1}; "
                  "#for (k, 0, 3) #for (i, 0, 4) #declare a = A[i]; #declare b = a * 2 + 1; "
                  "#if (k = 3) V(5, b) #end #end #end") ==
          "<3.0000,0.0000,0.0000,0.0000,0.0000> <3.0000,5.0000,0.0000,0.0000,0.0000> "
          "<3.0000,5.0000,7.0000,0.0000,0.0000> <3.0000,5.0000,7.0000,9.0000,0.0000> "
          "<3.0000,3.0000,3.0000,1.0000,1.0000>");
    CHECK(printed("#declare A = array[2] {\"a\", \"b\"}; #for (i, 0, 3) #declare a = A[mod(i, 2)]; "
                  "#declare b = (a = \"a\"); P(b) #end") == "1.000000 0.000000 1.000000 0.000000");
}

TEST_CASE("a number that has to be reported is reported each time", "[interpret]") {
    const auto [script, messages] = GENERATE(table<std::string, std::string>({
        {"#for (i, -2, 1) #declare a = 1 / i; #end",
         "warning: division by zero; the result is infinite\n"},
        {"#for (i, 1, -1, -1) #declare a = sqrt(i); #end",
         "error: there is no square root of -1\n"},
        {"#for (i, 2, 0, -1) #declare a = ln(i); #end", "error: there is no logarithm of 0\n"},
        {"#for (i, -1, 2) #declare a = acos(i); #end",
         "warning: the argument is 2; outside -1 to 1 the nearer end is taken\n"},
        {"#for (i, 2, 0, -1) #declare a = atan2(i, i); #end",
         "error: atan2(0, 0) has no direction\n"},
        {"#for (i, 2, 0, -1) #declare a = pow(i, i); #end",
         "error: 0 to the power of 0 has no value\n"},
        {"#for (i, 2, 0, -1) #declare a = vnormalize(<i, 0, 0>); #end",
         "warning: the zero vector has no direction; it stays zero\n"},
        {"#declare A = array[3] {1, 2, 3}; #for (i, 0, 3) #declare a = A[i]; #end",
         "error: the index must be from 0 to 2, but it is 3\n"},
        {"#declare A = array[3]; #declare A[0] = 1; #declare A[1] = 1; #for (i, 0, 2) #declare a = "
         "A[i] * 2; #end",
         "error: this element of the array was never set\n"},
        {"#declare p = <1, 2, 3>; #for (i, 0, 3) #if (i = 3) #declare p = 1; #end #declare a = "
         "p.y; "
         "#end",
         "error: there is no `.y` in a number\n"},
        {"#for (i, 0, 2) #declare a = rand(i); #end",
         "error: there is no random stream 0; seed(...) gives one\n"
         "error: there is no random stream 1; seed(...) gives one\n"
         "error: there is no random stream 2; seed(...) gives one\n"},
    }));
    INFO(script);
    CHECK(said(script).messages == messages);
}

TEST_CASE("random streams advance once, whatever happens in the expression", "[interpret]") {
    // The third value is drawn in an expression that also divides by zero.
    const std::string expected =
        printed("#declare R = seed(1); P(rand(R)) P(rand(R)) P(rand(R)) P(rand(R))");
    const Said mixed = said(prelude +
                            "#declare R = seed(1); #for (i, -2, 1) #declare a = rand(R) + "
                            "0 * (1 / i); P(select(i, a, 0, a)) #end");
    CHECK(mixed.printed.substr(0, 18) == expected.substr(0, 18));
    CHECK(mixed.printed.substr(27, 8) == expected.substr(27, 8));
    // Both branches of `? :` draw.
    CHECK(
        printed("#declare R = seed(1); #for (i, 0, 3) #declare a = (mod(i, 2) ? 0 : rand(R)); #end "
                "P(rand(R))") ==
        printed("#declare R = seed(1); #for (i, 0, 3) #declare a = rand(R); #end P(rand(R))"));
    CHECK(printed("#declare R = seed(1); #declare a = (1 ? 0 : rand(R)); P(rand(R))") ==
          "0.487121");
}

TEST_CASE("an element alias and a program see the same", "[interpret]") {
    CHECK(printed("#macro A(p) #for (k, 1, 3) #declare q[0] = k; #declare s = p + q[0]; #end P(s) "
                  "#end #declare q = array[1] {0}; A(q[0])") == "6.000000");
}

}  // namespace candelabra
