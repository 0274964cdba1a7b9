// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/object_functions.h"

#include "support/script.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

std::string printed_of_object(const std::string& script) {
    return debugged(
        "#version 3.7; #macro V(A) #debug vstr(3, A, \",\", 0, 2) #end\n"
        "#declare O = sphere { <1, 0, 0>, 2 }\n" +
        script);
}

}  // namespace

TEST_CASE("what can be asked of a declared object", "[objects]") {
    CHECK(printed_of_object("V(min_extent(O))") == "-1.00,-2.00,-2.00");
    CHECK(printed_of_object("V(max_extent(O))") == "3.00,2.00,2.00");
    CHECK(printed_of_object("#debug str(inside(O, x), 0, 0) #debug str(inside(O, 4*x), 0, 0)") ==
          "10");
    CHECK(printed_of_object("#declare N = y; V(trace(O, <1, 0, -9>, z, N)) V(N)") ==
          "1.00,0.00,-2.000.00,0.00,-1.00");
    CHECK(printed_of_object("V(trace(O, <9, 9, -9>, z))") == "0.00,0.00,0.00");
}

TEST_CASE("a text keeps its movements in another block", "[objects]") {
    CHECK(printed_of_object(
              "#declare A = text { ttf \"timrom.ttf\" \"I\" 1, 0 translate 5*y }"
              "#declare B = object { text { ttf \"timrom.ttf\" \"I\" 1, 0 translate 2*y } "
              "translate 3*y }"
              "V(max_extent(A) - max_extent(B))") == "0.00,0.00,0.00");
}

TEST_CASE("only objects can be asked", "[objects]") {
    CHECK(printed_of_object("#declare A = inside(3, x);") ==
          "error: `inside` takes a declared object here, but this is a number");
}

TEST_CASE("the tables of functions are in order, and complete together", "[objects]") {
    CHECK(std::ranges::is_sorted(functions(), {}, &FunctionInfo::name));
    CHECK(std::ranges::is_sorted(object_functions(), {}, &FunctionInfo::name));
    const auto table = all_functions();
    CHECK(std::ranges::is_sorted(table, {}, &FunctionInfo::name));
    for (const Word& word : reserved_words()) {
        if (word.word_class != WordClass::function && word.word_class != WordClass::unary_function)
            continue;
        if (word.spelling == "defined") continue;  // about a name, not a value
        INFO(word.spelling);
        CHECK(std::any_of(table.begin(), table.end(),
                          [&](const auto& f) { return f.name == word.spelling; }));
    }
    for (const FunctionInfo& function : table) {
        INFO(function.name);
        CHECK(function.least >= 1);
        CHECK(function.most >= function.least);
        CHECK_FALSE(function.help.empty());
    }
}

}  // namespace candelabra
