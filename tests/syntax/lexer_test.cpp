// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/lexer.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <cstdlib>

namespace candelabra {

namespace {

struct Lexed {
    explicit Lexed(const std::string& text) {
        const SourceId source = sources.add("test", text);
        tree.source = source;
        Lexer lexer(source, sources, names, tree, diagnostics);
        for (Token token = lexer.next(); token.kind != TokenKind::end_of_file;
             token = lexer.next()) {
            kinds += (kinds.empty() ? "" : " ") + std::string(name(token.kind));
            tokens.push_back(token);
        }
    }

    SourceStore sources;
    Names names;
    Tree tree;
    Diagnostics diagnostics;
    std::vector<Token> tokens;
    std::string kinds;
};

}  // namespace

TEST_CASE("a text becomes these tokens", "[syntax]") {
    const auto [text, kinds] = GENERATE(table<std::string, std::string>({
        {"", ""},
        {"sphere { a_1, 1 }", "word { name , number }"},
        {"a.x a . y", "name . constant name . constant"},
        {"5.x", "number constant"},
        {"<1, -2.5, .3>", "vector"},
        {"<1 -2 3>", "< number - number number >"},
        {"<a,1>", "< name , number >"},
        {"<=<>=!=!", "<= < >= != !"},
        {"#declare # \n declare #/* # */local", "#declare #declare #declare"},
        {"#if#end", "#if #end"},
        {"/* a /* b */ c */ 1 // 2\r3", "number number"},
        {"rgb color red texture array function sin max",
         "colour prefix colour channel layer array function literal unary function function"},
        {"defined(declare) defined (color) #ifdef(end) (color)",
         "function ( word ) function ( word ) #ifdef ( word ) ( colour )"},
        {"(version) version version < 3 sphere version 3",
         "( constant ) constant constant < number word constant number"},
        {"#version unofficial 3 unofficial", "#version unofficial number name"},
        {std::string("1\0 2\x1a 3", 7), "number number number"},
        {"\xEF\xBB\xBF"
         "1",
         "number"},
    }));
    INFO(text);
    const Lexed lexed(text);
    CHECK(lexed.kinds == kinds);
    CHECK(lexed.diagnostics.all().empty());
}

TEST_CASE("a number has this value", "[syntax]") {
    const auto [text, value] = GENERATE(table<std::string, double>({
        {"007", 7},
        {".5", .5},
        {"5.", 5},
        {"1e3", 1000},
        {"1.5E-2", .015},
        {"1e+2", 100},
        {"1.e2", 100},
        {"1e", 1},
        {"1e+", 1},
        {"1e999", HUGE_VAL},
        {"1e-999", 0},
        {"0." + std::string(330, '0') + "1", 0},
        {"1" + std::string(330, '0') + ".5", HUGE_VAL},
    }));
    INFO(text);
    const Lexed lexed(text);
    REQUIRE(lexed.tree.numbers.size() == 1);
    CHECK(lexed.tree.numbers[0] == value);
}

TEST_CASE("the numbers of a vector are kept in order", "[syntax]") {
    const Lexed lexed("< -1 ,\n+2.5e1, .5e >");
    REQUIRE(lexed.kinds == "vector");
    CHECK(lexed.tokens[0].count == 3);
    CHECK(lexed.tree.numbers == std::vector<double>{-1, 25, .5});
}

TEST_CASE("a string has this content", "[syntax]") {
    const auto [text, content] = GENERATE(table<std::string, std::string>({
        {R"("a\tb\\c\"d\'e")", "a\tb\\c\"d'e"},
        {R"("\u0041\u20AC")", "A\u20AC"},
        {"\"a\r\nb\rc\"", "a\nb\nc"},
        {R"(#include "a\new")", "a\\new"},
        {R"(png "a\new")", "a\\new"},
    }));
    INFO(text);
    const Lexed lexed(text);
    REQUIRE(lexed.tree.texts.size() == 1);
    CHECK(lexed.tree.texts[0] == content);
    CHECK(lexed.diagnostics.all().empty());
}

TEST_CASE("what is no token is reported and left out", "[syntax]") {
    const auto [text, message, kinds] = GENERATE(table<std::string, std::string, std::string>({
        {"1 % 2", "this character means nothing here", "number * number"},
        {"1 %", "this character means nothing here", "number"},
        {"a^-2", "this character means nothing here", "name * - number"},
        {"#else if (a)", "`#else if` is one word", "#elseif ( name )"},
        {"#endif", "there is no directive `#endif`", "#end"},
        {"#ff8000", "there is no directive `#ff8000`", ""},
        {"1 \xC3\xA9 2", "a name consists of the letters A to Z and a to z, digits and `_`",
         "number name number"},
        {"Gr\xC3\xB6ssen 2", "a name consists of the letters A to Z and a to z, digits and `_`",
         "name number"},
        {"1 \u2013 2", "this is a dash", "number - number"},
        {"1\u00A0+ 2", "this is a no-break space", "number + number"},
        {"\u201Ca\u201D 1", "this is a typographic quote", "string number"},
        {"0x1F", "numbers are written in decimal digits", "number"},
        {"end 1", "`end` needs a # before it", "#end number"},
        {"1.2.3", "a number has only one point", "number"},
        {"1..2", "a number has only one point", "number"},
        {"1 /* 2", "this comment has no end", "number"},
        {"\"abc", "this string has no end", "string"},
        {R"("\q")", "a string has no such escape", "string"},
        {"#delcare a", "there is no directive `#delcare`", "#declare name"},
        {"#sphere 1", "this `#` has no effect, for `sphere` is no directive", "word number"},
        {"#\trgb 1", "this `#` has no effect, for `rgb` is no directive", "colour prefix number"},
        {"1 # 2", "this `#` has no effect, for no word follows it", "number number"},
        {"declare a", "`declare` should have a # before it", "#declare name"},
        {"a; version 3.5", "`version` should have a # before it", "name ; #version number"},
        {"a == b", "this language writes `=`, not `==`", "name = name"},
        {"a && b", "this language writes `&`, not `&&`", "name & name"},
        {"a || b", "this language writes `|`, not `||`", "name | name"},
    }));
    INFO(text);
    const Lexed lexed(text);
    CHECK(lexed.kinds == kinds);
    REQUIRE(lexed.diagnostics.all().size() == 1);
    CHECK(lexed.diagnostics.all()[0].message == message);
}

TEST_CASE("numbers of any length are the nearest doubles", "[syntax]") {
    std::uint64_t state = 1;
    const auto next = [&] {
        return (state = state * 6364136223846793005u + 1442695040888963407u) >> 33;
    };
    for (int i = 0; i < 20000; ++i) {
        std::string digits;
        for (std::uint64_t n = next() % 20; n > 0; --n)
            digits += static_cast<char>('0' + next() % 10);
        digits.insert(next() % (digits.size() + 1), ".");
        if (digits == ".") continue;
        INFO(digits);
        const Lexed lexed(digits);
        REQUIRE(lexed.tree.numbers.size() == 1);
        REQUIRE(lexed.tree.numbers[0] == std::strtod(digits.c_str(), nullptr));
    }
}

}  // namespace candelabra
