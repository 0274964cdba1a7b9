// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/open_macros.h"

#include "syntax/parsed.h"
#include "syntax/print.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace candelabra {

namespace {

std::string squeezed(const std::string& text) {
    std::istringstream words(text);
    std::string result;
    for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
    return result;
}

}  // namespace

TEST_CASE("macros may open braces for each other", "[syntax]") {
    const auto [text, meaning] = GENERATE(table<std::string, std::string>({
        {"#macro A() union { #end #macro B() } #end A() x1 B() x2", "union { x1 }, x2"},
        {"#macro A(r) union { f(r) #end A(s) }", "union { f(s) }"},
        {"#macro A(r) union { f(r) #end A(-1) }", "#local r_of_A = -1;, union { f(r_of_A) }"},
        {"#macro A(r, q) union { #declare r = 2; q #end A(1, <a, 2, 3>) }",
         "#local r_of_A = 1; #local q_of_A = <a, 2, 3>;, union { #declare r_of_A = 2;, q_of_A }"},
        {"#macro A(r) union { #local r = r + q; r #end A(s) }", "union { #local s = s + q;, s }"},
        {"#macro A() union { #local q = 1; q #end A() } q",
         "union { #local q_of_A = 1;, q_of_A }, q"},
        {"#declare a = A() }", "#declare a = A(), /* broken */"},
        {"#macro A(r) union { r #end #declare a = A(1 + 1) }",
         "#declare a = #local r_of_A = 1 + 1; union { r_of_A }"},
        {"#macro M() } union { #end merge { a M() b }", "merge { a }, union { b }"},
        {"#macro A(p) union { p { #end A(sphere { 0, 1 }) } }",
         "#local p_of_A = sphere { 0, 1 };, union { p_of_A { } }"},
        // Called by macros before their definitions.
        {"#macro A() B() x1 #end #macro B() union { #end A() } ", "union { x1 }"},
        {"#macro A() B() #end #macro B() C() #end #macro C() union { #end A() }", "union { }"},
        {"#macro A() B() x1 C() #end #macro B() union { #end #macro C() } #end A()",
         "#macro A() union { x1 } #end, A()"},
        {"#macro A1() A2() #end #macro A2() A3() #end #macro A3() A4() #end #macro A4() A5() #end "
         "#macro A5() A6() #end #macro A6() A7() #end #macro A7() A8() #end #macro A8() A9() #end "
         "#macro A9() union { #end A1() }",
         "union { }"},
        {"#macro A() b #end A() #macro A() union { #end A() }", "#macro A() b #end, A() union { }"},
        // One called in another, and one that is redefined.
        {"#macro A() union { #end #macro B() A() merge { #end B() } }", "union { merge { } }"},
        {"#macro A() union { #end A() } #macro A() merge { #end A() }", "union { }, merge { }"},
        {"#macro A() #if (c) union { #else merge { #end #end A() b }",
         "#if (c) union { b } #else merge { b } #end"},
        {"#macro A(r) #if (r) union { #else merge { #end #end A(0) b } #if (0) a #else b #end",
         "merge { b } #if (0) #else b #end"},
        {"#macro A() union { #end #for (i, 1, 2) A() b } #end", "#for (i, 1, 2) union { b } #end"},
        {"#macro A() union { #end A() } #if (0) A(1) #end", "union { } #if (0) #end"},
        {"#macro P() + #end (1 P() 2)", "(1 + 2)"},
        {"#macro H(r) / r #end (1 H(2))", "(1 / 2)"},
        {"#macro N(r) #if (r) - #end #end (N(1) 5)", "(#if (1) - #end 5)"},
        // Half a pair of parentheses.
        {"#macro A() (1 #end #macro B() + 2) #end a(A() B())", "a((1 + 2))"},
        {"#macro A() (1 #end #declare q = A() + 3);", "#declare q = (1 + 3);"},
        {"#macro B(r) + r) #end #declare q = (1 B(2);", "#declare q = (1 + 2);"},
        // Half a vector.
        {"#macro A() <1, 2, #end #macro B() 3> #end A() c> <c, d, B() A() B()",
         "<1, 2, c>, <c, d, 3>, <1, 2, 3>"},
        {"#macro B(r) r, 3>.x * 2 #end (<c, B(d))", "(<c, d, 3>.x * 2)"},
        {"#macro A(r) (r < 2) f { r <1, c> } #end A(c)",
         "#macro A(r) (r < 2) f { r, <1, c> } #end, A(c)"},
        // A macro that is a value is called, unless it continues another value.
        {"#macro M() + 2 #end a(M()) (1 M())", "#macro M() +2 #end, a(M()), (1 + 2)"},
        {"#macro M(r) -r #end (1 M(a)) <1 M(2), 3>", "#macro M(r) -r #end, (1 - a), <1 - 2, 3>"},
        {"#macro M(r) -r #end (1 M(a + 1)) f { b M(a + 1) c }",
         "#macro M(r) -r #end, (1 - (a + 1)) f { b - (a + 1), c }"},
        {"#macro M(r) -r*r #end (1 M(a + 1))",
         "#macro M(r) -r * r #end, (1 #local r_of_M = a + 1; - r_of_M * r_of_M)"},
        // Macros whose braces match are not open.
        {"#macro A() union { } #end A()", "#macro A() union { } #end, A()"},
        {"#macro A() union { #end A() } #macro A() b #end A()", "union { } #macro A() b #end, A()"},
    }));
    INFO(text);
    const Parsed parsed(text);
    if (meaning.find("broken") == std::string::npos) {
        CHECK(parsed.messages() == "");
        CHECK(squeezed(print(parsed.tree, parsed.names)) == meaning);
    } else {
        CHECK(parsed.messages() != "");
    }
}

TEST_CASE("macros whose braces are an oversight are named", "[syntax]") {
    const auto [text, says] = GENERATE(table<std::string, std::string>({
        {"#macro A() union { #end", "this `{` is not closed before `#end`"},
        {"#macro A() } #end", "`}` closes nothing that is open"},
        {"#macro A() union { #end A()", "this `{` is not closed before `#end`"},
        {"#macro A() union { #end merge { A() } A()", "this `{` is not closed before `#end`"},
        {"#macro A() } #end A()", "`}` closes nothing that is open"},
        {"#macro A() union { #end #macro B() } #end A(1) B()",
         "macro `A` takes 0 arguments, but here is 1"},
        {"#macro A(r) union { #end #macro B() } #end A() B()",
         "macro `A` takes 1 argument, but here are 0"},
        {"#macro A() (1 #end", "this `(` is not closed before `#end`"},
        {"#macro A() 1) #end", "`)` closes nothing that is open"},
        {"#macro A() <1, 2 #end", "this `<` is not closed before `#end`"},
        {"#macro A() 1, 2> #end", "`>` closes nothing that is open"},
        {"#macro A() { (1 } #end", "`}` comes before the end of `(`"},
        // Called before their definitions.
        {"A() #macro A() union { #end", "this `{` is not closed before `#end`"},
        {"merge { A() b } #macro A() union { #end", "this `{` is not closed before `#end`"},
        // Not the macros' fault: they are called in pairs.
        {"#macro A() union { #end #macro B() } #end A() B() union {", "`{` has no end"},
        {"#macro A() #if (c) union { { #else } } #end #end", "`}` closes nothing that is open"},
        // Whether this macro is defined is not known before the scene is walked.
        {"#if (a) #macro A() union { #end #end", "this `{` is not closed before `#end`"},
    }));
    INFO(text);
    CHECK_THAT(Parsed(text).messages(), Catch::Contains(says));
}

}  // namespace candelabra
