// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/token_stream.h"

#include "syntax/parsed.h"
#include "syntax/print.h"

#include <catch2/catch.hpp>

namespace {

std::string squeezed(const std::string& text) {
    std::string result;
    for (const char c : text)
        if (c != ' ' || !result.ends_with(' ')) result += c == '\n' ? ' ' : c;
    std::string once;
    for (const char c : result)
        if (c != ' ' || !once.ends_with(' ')) once += c;
    while (once.ends_with(' ')) once.pop_back();
    return once;
}

}  // namespace

TEST_CASE("what follows branches that open braces is part of each", "[syntax]") {
    const auto [text, meaning] = GENERATE(table<std::string, std::string>({
        {"#if (a) merge { #else union { #end b } c",
         "#if (a) merge { b } #else union { b } #end, c"},
        {"#if (a) merge { b #elseif (c) union { #else sphere { d #end e { f } } g",
         "#if (a) merge { b e { f } } #elseif (c) union { e { f } } #else sphere { d e { f } } "
         "#end, g"},
        {"#ifdef (a) merge { union { #else merge { merge { #end b } c }",
         "#ifdef (a) merge { union { b }, c } #else merge { merge { b }, c } #end"},
        {"#if (a) merge { #else union { #end #if (b) c #else d #end }",
         "#if (a) merge { #if (b) c #else d #end } #else union { #if (b) c #else d #end } #end"},
        {"#if (a) merge { #else union { #end #if (b) c { #else d { #end e } }",
         "#if (a) merge { #if (b) c { e } #else d { e } #end } #else union { #if (b) c { e } "
         "#else d { e } #end } #end"},
    }));
    INFO(text);
    const Parsed parsed(text);
    CHECK(parsed.messages() == "");
    CHECK(squeezed(print(parsed.tree, parsed.names)) == meaning);
}

TEST_CASE("branches that do not open the same are an error", "[syntax]") {
    const std::string text = GENERATE(
        as<std::string>(), "#if (a) merge { #end b }", "#if (a) merge { #else #end b }",
        "#if (a) merge { #else union { union { #end b }",
        "#if (a) merge { #elseif (c) union { #end b }", "#if (a) merge { #else union { #end b",
        "#switch (a) #case (1) merge { #else "
        "union { #end }",
        "#if (a) merge { #else b }");
    INFO(text);
    CHECK(Parsed(text).messages() != "");
}
