// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/brackets.h"

#include "syntax/parsed.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

namespace candelabra {

TEST_CASE("a minus sign behind a string belongs to the next value", "[syntax]") {
    const Parsed parsed("text { \"a\" -.3, 0 }");
    CHECK(parsed.messages() == "");
    CHECK(parsed.dumped() == Parsed("text { \"a\", -.3, 0 }").dumped());
}

TEST_CASE("an operator at the beginning of a part joins the expression before it", "[syntax]") {
    const auto [text, tree] = GENERATE(table<std::string, std::string>({
        {"1 #if (a) + 2 #end",
         "chain\n  number 1\n  #if\n    branch\n      condition: group\n        name a\n      "
         "body: "
         "chain\n        joined +\n          number 2\n"},
        {"1, #if (a) -2 #end",
         "number 1\n#if\n  branch\n    condition: group\n      name a\n    body: number -2\n"},
        {"#macro M(a) #if (a) -1 #end #end",
         "#macro M\n  parameters: parameter a\n  body: #if\n    branch\n      condition: group\n   "
         "     "
         "name a\n      body: number -1\n"},
        {"rotate #if (a) -y #end",
         "word rotate\n#if\n  branch\n    condition: group\n      name a\n    body: unary -\n      "
         "constant y\n"},
        {"1 #if (a) 2 #end",
         "number 1\n#if\n  branch\n    condition: group\n      name a\n    "
         "body: number 2\n"},
    }));
    INFO(text);
    const Parsed parsed(text);
    CHECK(parsed.messages() == "");
    CHECK(parsed.dumped() == tree);
}

TEST_CASE("what does not match is reported once", "[syntax]") {
    const auto [text, messages] = GENERATE(table<std::string, std::string>({
        {"sphere { 0, 1", "1:8 error: `{` has no end\n"},
        {"sphere { 0, 1 } }", "1:17 error: `}` closes nothing that is open\n"},
        {"sphere { 0, 1 ) }", "1:15 error: `)` closes nothing that is open\n"},
        {"sphere { 0, (1 }", "1:16 error: `}` comes before the end of `(`\n"},
        {"#if (1) sphere { 0, 1 }", "1:1 error: `#if` has no `#end`\n"},
        {"#end", "1:1 error: `#end` closes nothing that is open\n"},
        {"#else", "1:1 error: `#else` belongs between `#if` and its `#end`, and none is open\n"},
        {"#case (1)",
         "1:1 error: `#case` belongs between `#switch` and its `#end`, and none is open\n"},
        {"#if (1) 1 #else 2 #else 3 #end", "1:19 error: `#else` cannot follow `#else`\n"},
        {"#if (1) 1 #else 2 #elseif (1) 3 #end", "1:19 error: `#elseif` cannot follow `#else`\n"},
        {"sphere { #if (1) 0 }", "1:20 error: `}` comes before the `#end` of `#if`\n"},
        // A branch that opens a brace that another closes.
        {"#if (1) union { #end sphere { 0, 1 } #if (2) } #end",
         "1:15 error: this `{` is not closed before `#end`\n"},
        {"#if (a) union { #else merge { } #end 1 }",
         "1:15 error: this `{` is not closed before `#else`\n"},
    }));
    INFO(text);
    CHECK(Parsed(text).messages() == messages);
}

TEST_CASE("a message about brackets shows both places", "[syntax]") {
    const Parsed parsed("union {\n  sphere { 0, 1\n}\nbox { 0, 1 }\n");
    REQUIRE(parsed.diagnostics.all().size() == 1);
    CHECK(format(parsed.diagnostics.all()[0], parsed.sources, false) ==
          "error: `{` has no end\n"
          " --> test.pov:1:7\n"
          "  |\n"
          "1 | union {\n"
          "  |       ^\n"
          "2 |   sphere { 0, 1\n"
          "  |          - perhaps this one is meant:\n"
          "3 | }\n"
          "  | - this `}` stands further left\n");
}

TEST_CASE("directives stand between operators", "[syntax]") {
    const auto [text, messages] = GENERATE(table<std::string, std::string>({
        {"#declare a = (1 + #if (b) 2 #else 3 #end * 4);", ""},
        {"#declare a = (1 * #declare b = 2; #undef c b);", ""},
        {"#declare a = (1 + #end);",
         "1:19 error: `#end` closes nothing that is open\n"
         "1:23 error: expected a value, but found `)`\n"},
    }));
    INFO(text);
    CHECK(Parsed(text).messages() == messages);
}

TEST_CASE("after an error the parser goes on at the end of the bracket or at the next directive",
          "[syntax]") {
    const auto [text, messages] = GENERATE(table<std::string, std::string>({
        {"sphere { (1 + ), 2 } box { = }",
         "1:15 error: expected a value, but found `)`\n1:28 error: `=` does not fit here\n"},
        {"sphere { 0 = { 1 } 3 } box { ? 1 } ",
         "1:12 error: `=` does not fit here\n1:30 error: `?` does not fit here\n"},
        {"#declare sphere = 3; #declare b = 4;\n#declare = 5;",
         "1:10 error: `sphere` is a word of the language and cannot be the name of something "
         "else\n2:10 error: expected a name or `(`, but found `=`\n"},
        {"#if (1 2) sphere { 0, 1 } #end #while () #end",
         "1:8 error: expected `)`, but found `2`\n1:40 error: expected a value, but found `)`\n"},
    }));
    INFO(text);
    CHECK(Parsed(text).messages() == messages);
}

TEST_CASE("the depth of directives has a limit", "[syntax]") {
    const auto nested = [](const std::string& opener, int times) {
        std::string text;
        for (int i = 0; i < times; ++i) text += opener;
        for (int i = 0; i < times; ++i) text += " #end";
        return Parsed(text).messages();
    };
    for (const std::string opener :
         {"#if (1) ", "#while (0) ", "#for (I, 1, 2) ", "#switch (1) #case (1) ", "#ifdef (A) "}) {
        INFO(opener);
        CHECK(nested(opener, 10'000) == "");
        const std::string found = nested(opener, 60'000);
        CHECK(found.find("more than 10000 directives are open here") != std::string::npos);
        CHECK(std::ranges::count(found, '\n') == 1);
    }
}

TEST_CASE("long lists of indices, parameters and channels are read", "[syntax]") {
    std::string indices, parameters, channels;
    for (int i = 0; i < 100'000; ++i) {
        indices += "[0]";
        parameters += "A" + std::to_string(i) + ", ";
        channels += " red 1";
    }
    CHECK(Parsed("A" + indices).messages() == "");
    CHECK(Parsed("#macro M(" + parameters + ") #end").messages() == "");
    CHECK(Parsed("pigment { color" + channels + " }").messages() == "");
}

}  // namespace candelabra
