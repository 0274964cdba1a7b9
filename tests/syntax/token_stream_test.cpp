// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/token_stream.h"

#include "syntax/parsed.h"
#include "syntax/print.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string without_double_spaces(const std::string& text) {
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
        {"#if (a) merge #else union #end { b { c } } d",
         "#if (a) merge { b { c } } #else union { b { c } } #end, d"},
    }));
    INFO(text);
    const Parsed parsed(text);
    CHECK(parsed.messages() == "");
    CHECK(without_double_spaces(print(parsed.tree, parsed.names)) == meaning);
}

TEST_CASE("what follows a #switch whose parts open braces is part of each", "[syntax]") {
    const auto [text, meaning] = GENERATE(table<std::string, std::string>({
        {"#switch (a) #case (0) merge { b #break #case (1) union { c #break #else d { e #end f } g",
         "#switch (a) #case (0) merge { b, f } #break #case (1) union { c, f } #break #else d { e, "
         "f } #end, g"},
        {"#switch (a) #case (0) mesh { b #break #end } c",
         "#switch (a) #case (0) mesh { b } #break #end, c"},
        {"#switch (a) #case (0) #case (1) a { { b #break #range (2, 3) c { { d #break #end } e } f",
         "#switch (a) #case (0) #case (1) a { { b }, e } #break #range (2, 3) c { { d }, e } "
         "#break "
         "#end, f"},
        {"#switch (a) #else merge { b #end c }", "#switch (a) #else merge { b, c } #end"},
        {"d { #switch (a) #case (0) merge { b #break #case (1) #break #end } }",
         "d { #switch (a) #case (0) merge { b } #break #case (1) #break #end }"},
        {"#switch (a) #case (0) merge { #switch (b) #case (1) c { #break #end d } #break #end e }",
         "#switch (a) #case (0) merge { #switch (b) #case (1) c { d } #break #end, e } #break "
         "#end"},
        // Whole elements stay as they are, and nothing behind a #break is read.
        {"#switch (a) #case (0) merge { b } #break ) ' #foo { #case (1) c #break #end d",
         "#switch (a) #case (0) merge { b } #break #case (1) c #break #end, d"},
    }));
    INFO(text);
    const Parsed parsed(text);
    CHECK(parsed.messages() == "");
    CHECK(without_double_spaces(print(parsed.tree, parsed.names)) == meaning);
}

TEST_CASE("parts of a #switch that open different braces are reported", "[syntax]") {
    CHECK(Parsed("#switch (a) #case (0) merge { b #break #case (1) c { d { #break #end }")
              .messages()
              .find("is not closed before") != std::string::npos);
}

TEST_CASE("of branches that are no whole elements only that for the version is read", "[syntax]") {
    const auto [text, meaning] = GENERATE(table<std::string, std::string>({
        {"#if (version >= 3.1) merge { #end b #if (version >= 3.1) } #end c", "merge { b }, c"},
        {"#if (version < 3.1) merge { #end b #if (version < 3.1) } #end c", "b, c"},
        {"#version 3; #if (version < 3.1) merge { #end b #if (version < 3.1) } #end",
         "#version 3;, merge { b }"},
        {"#version unofficial 3; #if (version < 3.1) merge { #end b #if (version < 3.1) } #end",
         "#version unofficial 3;, merge { b }"},
        {"a { #if (version = 3.7) merge #else union #end { b } }", "a { merge { b } }"},
        {"#if (version > 3.5) merge { union #else sphere #end { b } #if (version > 3.5) } #end",
         "merge { union { b } }"},
        // Whole elements stay as they are.
        {"#if (version < 3.1) merge { b } #else union { c } #end d",
         "#if (version < 3.1) merge { b } #else union { c } #end, d"},
    }));
    INFO(text);
    const Parsed parsed(text);
    CHECK(parsed.messages() == "");
    CHECK(without_double_spaces(print(parsed.tree, parsed.names)) == meaning);
}

TEST_CASE("what stands between two conditions of the same text may have braces by choice",
          "[syntax]") {
    const auto [text, meaning] = GENERATE(table<std::string, std::string>({
        {"#if (a > 1) merge { #end b { c } #if ( a>1 ) } #end d",
         "#if (a > 1) merge { b { c } } #else b { c } #end, d"},
        {"#if (a) merge { union { #end b #if (c) d #end #if (a) e } } #end",
         "#if (a) merge { union { b #if (c) d #end, e } } #else b #if (c) d #end #end"},
        {"#if (a) merge { #end #if (b) union { #end c #if (b) } #end #if (a) } #end",
         "#if (a) merge { #if (b) union { c } #else c #end } #else #if (b) union { c } #else c "
         "#end #end"},
    }));
    INFO(text);
    const Parsed parsed(text);
    CHECK(parsed.messages() == "");
    CHECK(without_double_spaces(print(parsed.tree, parsed.names)) == meaning);
}

TEST_CASE("branches that do not open the same are an error", "[syntax]") {
    const std::string text = GENERATE(
        as<std::string>(), "#if (a) merge { #end b }", "#if (a) merge { #else #end b }",
        "#if (a) merge { #else union { union { #end b }",
        "#if (a) merge { #elseif (c) union { #end b }", "#if (a) merge { #else union { #end b",
        "#switch (a) #case (1) merge { #else "
        "union { #end }",
        "#if (a) merge { #else b }", "#if (version > 3) merge { #end b",
        "#if (a) merge { #end b #if (c) } #end", "#if (a) merge { #end b #if (a) } } #end");
    INFO(text);
    CHECK(Parsed(text).messages() != "");
}

}  // namespace candelabra
