// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/parser.h"

#include "syntax/parsed.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("vectors in a row are read as they are one by one", "[syntax]") {
    const auto [text, messages] = GENERATE(table<std::string, std::string>({
        {"mesh2 { 3, <1, 2, 3>, <4, 5, 6>, <7, 8, 9> }", ""},
        {"mesh2 { 3, <1, 2, 3>, <4, 5, 6>, <7, 8, 9> * 2 }", ""},
        {"mesh2 { 3, <1, 2, 3>, <4, 5, 6>, <7, 8, 9>, }", ""},
        {"mesh2 { 3, <1, 2, 3>, <4, 5, 6>, a { <1, 2>, <3, 4>, b } }", ""},
        {"mesh2 { 3, <1, 2, 3>, <4, 5, 6>,, <7, 8, 9> }", "1:33 error: two commas in a row\n"},
        {"mesh2 { 3, <1, 2, 3>, <4, 5, 6>, = 3 }", "1:34 error: `=` does not fit here\n"},
    }));
    INFO(text);
    CHECK(Parsed(text).messages() == messages);
    // Without the 3 and its comma, the first vector is read alone.
    std::string other = text;
    other.replace(other.find("3, "), 3, "3  ");
    if (messages.empty()) CHECK(Parsed(text).dumped() == Parsed(other).dumped());
}

TEST_CASE("operators bind as in POV-Ray", "[syntax]") {
    const auto [text, same] = GENERATE(table<std::string, std::string>({
        {"(1 + 2 * 3)", "(1 + (2 * 3))"},
        {"(1 - 2 - 3)", "((1 - 2) - 3)"},
        {"(2 * -a.x)", "(2 * (-(a.x)))"},
        {"(1 < 2 < 3)", "((1 < 2) < 3)"},
        {"(a | b & c)", "((a | b) & c)"},
        {"(a = 1 & b = 2)", "((a = 1) & (b = 2))"},
        {"(a ? b : c ? d : e)", "(a ? b : (c ? d : e))"},
        {"(!a + b)", "((!a) + b)"},
    }));
    INFO(text);
    // The same except for groups.
    const auto plain = [](std::string dumped) {
        std::string result;
        std::size_t from = 0;
        while (from < dumped.size()) {
            const std::size_t end = dumped.find('\n', from) + 1;
            std::string line = dumped.substr(from, end - from);
            line.erase(0, line.find_first_not_of(' '));
            if (const std::size_t label = line.find(": "); label != std::string::npos)
                line.erase(0, label + 2);
            if (line != "group\n") result += line;
            from = end;
        }
        return result;
    };
    CHECK(plain(Parsed(text).dumped()) == plain(Parsed(same).dumped()));
}

TEST_CASE("elements stand side by side", "[syntax]") {
    const auto [text, count] = GENERATE(table<std::string, std::size_t>({
        {"1 2", 2},
        {"1 -2", 1},
        {"1, -2", 2},
        {"<0,0,0><1,0,0>.5", 3},
        {"a (b)", 0},
        {"a [1]", 1},
        {"a, [1]", 2},
        {"scale -2", 2},
        {"a < 1, 2>", 2},
        {"rgb 1 rgb 2", 2},
        {"no_shadow rotate y", 3},
        {"cylinder radius 2", 3},
        {"filter all 1", 3},
        {"sqr cube", 2},
    }));
    INFO(text);
    const Parsed parsed(text);
    CHECK(parsed.messages() == "");
    std::size_t found = 0;
    for (NodeId id = parsed.tree.first; id != no_node; id = parsed.tree[id].next) ++found;
    if (count > 0)
        CHECK(found == count);
    else
        CHECK(parsed.dumped().starts_with("call a"));
}

TEST_CASE("every node knows its place", "[syntax]") {
    const Parsed parsed("sphere { <1, 2, 3>, 4 + 5 }");
    const Tree& tree = parsed.tree;
    const auto text = [&](NodeId id) {
        return std::string(parsed.sources.text(parsed.source)
                               .substr(tree[id].first, tree[id].last - tree[id].first));
    };
    CHECK(text(tree.first) == "sphere { <1, 2, 3>, 4 + 5 }");
    const NodeId centre = tree.get<node::Block>(tree.first).body;
    CHECK(text(centre) == "<1, 2, 3>");
    CHECK(text(tree[centre].next) == "4 + 5");
    CHECK(text(tree.get<node::Binary>(tree[centre].next).right) == "5");
}

TEST_CASE("a message says what would have fitted", "[syntax]") {
    const auto [text, message, help] = GENERATE(table<std::string, std::string, std::string>({
        {"#declare a = 1 < 2;", "expected a value, `,` or `>`, but found `;`",
         "a vector ends in `>`; comparisons are written in parentheses: (a < b)"},
        {"#declare a = 1 > 2;", "`>` does not fit here",
         "comparisons and conditions are written in parentheses: (a > b)"},
        {"a = 3;", "`=` does not fit here", "a name gets a value by `#declare Name = value;`"},
        {"#declare a 3;", "expected `=`, but found `3`", ""},
        {"#declare c = rgb 1 + rgb 2;", "expected a value, but found `rgb`",
         "a colour word stands before the whole value: rgb (A + B), not A + rgb B"},
        {"#for (i, 1, 2 #end", "`#end` comes before the end of `(`", "add the missing `)`"},
        {"#macro sphere() #end",
         "`sphere` is a word of the language and cannot be the name of something else",
         "names with a capital letter are always free: `Sphere`"},
        {"#include", "expected a value, but found the end of the file", ""},
        {"box { 1 + }", "expected a value, but found `}`", ""},
        {"<1, 2", "expected a value, `,` or `>`, but found the end of the file",
         "a vector ends in `>`; comparisons are written in parentheses: (a < b)"},
    }));
    INFO(text);
    const Parsed parsed(text);
    REQUIRE(parsed.diagnostics.all().size() == 1);
    CHECK(parsed.diagnostics.all()[0].message == message);
    CHECK(parsed.diagnostics.all()[0].help == help);
}

TEST_CASE("depth and size are no obstacle", "[syntax]") {
    const int n = 100'000;
    const auto many = [](const std::string& part, int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += part;
        return text;
    };
    CHECK(Parsed(many("(", n) + "1" + many(")", n)).messages() == "");
    CHECK(Parsed(many("union {", n) + many("}", n)).messages() == "");
    // Directives have a limit; see brackets_test.cpp.
    CHECK(Parsed(many("#if (1) ", n / 10) + many("#end ", n / 10)).messages() == "");
    CHECK(Parsed(many("-", n) + "1").messages() == "");
    CHECK(Parsed("mesh2 {" + many("<1, 2, 3>, ", n) + "}").messages() == "");
}

TEST_CASE("any bytes give a tree", "[syntax]") {
    // Pieces of the language in random order: the parser neither crashes nor hangs.
    const std::vector<std::string> pieces = {
        "{",       "}",     "(",      ")",     "[",     "]",       "<",      ">",
        "1",       "a",     "sphere", "#if",   "#else", "#end",    "#macro", "#declare",
        "=",       ",",     ";",      "\"s\"", "rgb",   "texture", "array",  "function",
        "#switch", "#case", "#for",   ".",     "red",   "+",       "?",      ":"};
    std::uint32_t state = 12345;
    for (int round = 0; round < 2000; ++round) {
        std::string text;
        for (int i = 0; i < 30; ++i) {
            state = state * 1664525u + 1013904223u;
            text += pieces[(state >> 16) % pieces.size()] + " ";
        }
        const Parsed parsed(text);
        CHECK(parsed.tree.source == parsed.source);
        for (const Diagnostic& d : parsed.diagnostics.all()) CHECK(d.message != "");
    }
}

}  // namespace candelabra
