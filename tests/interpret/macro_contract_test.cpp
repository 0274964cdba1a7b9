// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/macro_contract.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The errors alone: the macros of these tests do not use all of their parameters.
std::string errors_of(const std::string& script) {
    const std::string messages = candelabra::said(script).messages;
    std::string result;
    for (std::size_t at = 0; at < messages.size();) {
        const std::size_t end = messages.find('\n', at) + 1;
        if (messages.compare(at, 6, "error:") == 0) result += messages.substr(at, end - at);
        at = end;
    }
    return result;
}

}  // namespace

TEST_CASE("arguments that a macro accepts", "[interpret]") {
    const auto [script, printed] = GENERATE(table<std::string, std::string>({
        {"#macro M(A > 0) P(A) #end M(1) M(1e-9)", "1.000000 0.000000"},
        {"#macro M(A whole >= 1) P(A) #end M(3)", "3.000000"},
        {"#macro M(A vector >= 0) V(3, A) #end M(2*x) M(<1, 2, 3>)",
         "<2.0000,0.0000,0.0000> <1.0000,2.0000,3.0000>"},
        {"#macro M(A vector) P(1) #end M(2) M(<1, 2, 3, 4>) M(rgb 1)",
         "1.000000 1.000000 1.000000"},
        {"#macro M(A string or number) P(1) #end M(2) M(\"a\")", "1.000000 1.000000"},
        {"#macro M(A array[] >= 2) P(A[1]) #end M(array[2] {3, 4})", "4.000000"},
        {"#macro M(A number or array) P(1) #end M(array[2][2] {{3, 4}, {5, 6}}) M(1)",
         "1.000000 1.000000"},
        {"#macro M(A, B > A < pi) P(B) #end M(1, 2)", "2.000000"},
        {"#macro M(A, optional B >= 1) P(A) #end M(1) M(2,) M(3, 1)", "1.000000 2.000000 3.000000"},
        {"#macro M(A spline) P(A(0).x) #end M(spline { linear_spline 0, x, 1, y })", "1.000000"},
        {"#macro M(A function) P(A(2)) #end #declare F = function(x) { x + 1 }; M(F)", "3.000000"},
        {"#macro M(A whole) #declare A = 0.5; #end #declare B = 2; M(B) P(B)", "0.500000"},
        // The words are names elsewhere, and parameters between commas.
        {"#macro M(number, whole, or) P(number + whole + or) #end M(1, 2, 3)", "6.000000"},
        {"#declare whole = 4; P(whole)", "4.000000"},
    }));
    INFO(script);
    CHECK(errors_of(prelude + script) == "");
    CHECK(said(prelude + script).printed == printed + " ");
}

TEST_CASE("an argument that a macro does not accept is one message", "[interpret]") {
    const auto [script, expected] = GENERATE(table<std::string, std::string>({
        {"#macro M(A > 0) #end M(0)", "a number above 0, but it is 0"},
        {"#macro M(A > 0) #end M(0/1 - 1e-30)", "a number above 0, but it is -1e-30"},
        {"#macro M(A >= 0 <= 1) #end M(1.5)", "a number from 0 to 1, but it is 1.5"},
        {"#macro M(A > 0 < 1) #end M(1)", "a number above 0 and below 1, but it is 1"},
        {"#macro M(A <= -1) #end M(1)", "a number of at most -1, but it is 1"},
        {"#macro M(A > 0) #end M(\"1\")", "a number above 0, but it is a string"},
        {"#macro M(A > 0) #end M(x)", "a number above 0, but it is <1, 0, 0>"},
        {"#macro M(A whole) #end M(0.5)", "a whole number, but it is 0.5"},
        {"#macro M(A whole) #end M(1e999)", "a whole number, but it is inf"},
        {"#macro M(A whole >= 1) #end M(0)", "a whole number of at least 1, but it is 0"},
        {"#macro M(A whole vector >= 1) #end M(<1, 2, 0>)",
         "a vector of whole numbers of at least 1, but it is <1, 2, 0>"},
        {"#macro M(A vector > 0) #end M(x)", "a vector of numbers above 0, but it is <1, 0, 0>"},
        {"#macro M(A string) #end M(1)", "a string, but it is 1"},
        {"#macro M(A object or array) #end M(1)", "an object or an array, but it is 1"},
        {"#macro M(A array[]) #end M(array[1][2] {{1, 2}})",
         "an array of 1 dimension, but it is an array of 2 dimensions"},
        {"#macro M(A array[] >= 2) #end M(array[1] {1})",
         "an array of 1 dimension with at least 2 elements, but it has 1"},
        {"#macro M(A array > 2 < 4) #end M(array[5])",
         "an array with more than 2 and fewer than 4 elements, but it has 5"},
        {"#macro N(A) M(A) #end #macro M(A color) #end N(\"red\")", "a colour, but it is a string"},
    }));
    INFO(script);
    const std::string errors = errors_of(prelude + script);
    CHECK(errors.find("error: `A` of `M` must be " + expected) == 0);
    CHECK(errors.find("error:", 1) == std::string::npos);
}

TEST_CASE("all arguments that a macro refuses are reported", "[interpret]") {
    const std::string macro = prelude + "#macro M(A whole, B > A, C > 0) P(1) #end ";
    CHECK(errors_of(macro + "M(1, 0, -1)") ==
          "error: `B` of `M` must be a number above `A` (1), but it is 0\n"
          "error: `C` of `M` must be a number above 0, but it is -1\n");
    // Nothing is said of a bound that was refused itself.
    CHECK(errors_of(macro + "M(\"a\", 0, 1)") ==
          "error: `A` of `M` must be a whole number, but it is a string\n");
    CHECK(said(macro + "M(1, 0, -1)").printed == "");
}

TEST_CASE("contracts that cannot be kept are refused where they stand", "[interpret]") {
    CHECK(errors_of("#macro M(A sphere) #end").find("error: `sphere` is no kind of value") == 0);
    CHECK(errors_of("#macro M(A object > 1) #end") ==
          "error: bounds are for numbers, vectors and arrays, not for an object\n");
}

}  // namespace candelabra
