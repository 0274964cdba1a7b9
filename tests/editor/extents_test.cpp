// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/extents.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Returns the declarations' texts, each followed by a bar.
std::string whole(const std::string& text) {
    Names names;
    const EditedFile file = read_tokens(text, names);
    std::string all;
    for (const Part& part : extents(file)) all += std::string(file.part(part)) + "|";
    return all;
}

}  // namespace

TEST_CASE("a declaration goes from its directive to the end of its value") {
    for (const std::string declaration :
         {"#declare A = 1;", "#local A = sphere { 0, 1 };", "#declare A = texture { } texture { }",
          "# declare A = rgb <1, 0, 0> filter 0.5;", "#declare A[1][2] = array[2] { 1, 2 };",
          "#declare A = #if (B) 1 #else 2 #end;", "#declare A = 1 #for (1, 2, 3) + 1 #end",
          "#declare deprecated once \"old\" A = function(x) { x < 1 };", "#fopen A \"a\" write",
          "#macro A() union { #end"}) {
        CAPTURE(declaration);
        CHECK(whole("sphere { 0, 1 }\n" + declaration + "\nbox { 0, 1 }") == declaration + "|");
    }
    CHECK(whole("#macro M(A, B) #local C = A; #end 7") ==
          "#macro M(A, B) #local C = A; #end|#macro M(A, B) #local C = A; #end|"
          "#macro M(A, B) #local C = A; #end|#local C = A;|");
    CHECK(whole("#declare (A, B) = f(1); 7") == "#declare (A, B) = f(1);|#declare (A, B) = f(1);|");
    CHECK(whole("#for (I, 1, 2) A #end 7") == "#for (I, 1, 2) A #end|");
}

TEST_CASE("what cannot be read has its name at least") {
    CHECK(whole("#declare A") == "#declare A|");
    CHECK(whole("sphere {\n#declare A = \n}") != "");
    CHECK(whole("#macro A(B") == "#macro A(B|#macro A(B|");
    CHECK(whole("#declare A = sphere { 0, ; #declare B = 2;").ends_with("#declare B = 2;|"));
    CHECK(whole("").empty());
}

}  // namespace candelabra
