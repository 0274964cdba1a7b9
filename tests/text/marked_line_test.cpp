// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/marked_line.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace candelabra {

namespace {

using Rows = std::vector<std::string>;

Rows rows(std::string_view line, const std::vector<Mark>& marks) {
    const MarkedLine shown = marked_line(line, marks, {});
    Rows all = {shown.source};
    all.insert(all.end(), shown.below.begin(), shown.below.end());
    return all;
}

std::string times(int count, const std::string& part) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
}

}  // namespace

TEST_CASE("one mark has its text beside it") {
    CHECK(rows("a torus", {{2, 7, true, "here"}}) == Rows{"a torus", "  ^^^^^ here"});
    CHECK(rows("a torus", {{2, 7, false, ""}}) == Rows{"a torus", "  -----"});
    CHECK(rows("a", {}) == Rows{"a"});
}

TEST_CASE("an empty range, the end of a line and what lies beyond are one caret") {
    CHECK(rows("abc", {{1, 1, true, ""}}) == Rows{"abc", " ^"});
    CHECK(rows("abc", {{3, 3, true, ""}}) == Rows{"abc", "   ^"});
    CHECK(rows("abc", {{9, 12, true, ""}}) == Rows{"abc", "   ^"});
    CHECK(rows("", {{0, 0, true, "x"}}) == Rows{"", "^ x"});
}

TEST_CASE("tabs, wide encodings and control characters keep marks aligned") {
    CHECK(rows("\tab", {{1, 2, true, ""}}) == Rows{"    ab", "    ^"});
    CHECK(rows("a\tb\tc", {{4, 5, true, ""}}) == Rows{"a   b   c", "        ^"});
    CHECK(rows("a\tb", {{1, 2, true, ""}}) == Rows{"a   b", " ^^^"});
    CHECK(rows("é€🙂x", {{9, 10, true, ""}}) == Rows{"é€🙂x", "   ^"});
    CHECK(rows("é€🙂x", {{2, 9, true, ""}}) == Rows{"é€🙂x", " ^^"});
    CHECK(rows("\x1b[1mx\xE9y", {{4, 6, true, ""}}) == Rows{"␛[1mx\uFFFDy", "    ^^"});
    CHECK(rows("ab  \t", {{0, 2, true, ""}}) == Rows{"ab", "^^"});
}

TEST_CASE("texts that do not fit beside hang below their marks, from right to left") {
    CHECK(rows("torus { 4, 5 }",
               {{11, 12, true, "minor"}, {0, 5, false, "this"}, {8, 9, false, "major"}}) ==
          Rows{"torus { 4, 5 }", "-----   -  ^ minor", "|       |", "|       major", "this"});
    CHECK(rows("ab cd", {{0, 2, true, "first"}, {3, 5, false, "second"}}) ==
          Rows{"ab cd", "^^ -- second", "|", "first"});
    CHECK(rows("ab cd", {{0, 2, true, "first"}, {3, 5, false, ""}}) ==
          Rows{"ab cd", "^^ --", "|", "first"});
}

TEST_CASE("the main mark lies over the others") {
    CHECK(rows("abcdef", {{2, 4, true, "inner"}, {0, 6, false, "outer"}}) ==
          Rows{"abcdef", "--^^-- outer", "  |", "  inner"});
    CHECK(rows("abcdef", {{0, 6, false, "other"}, {0, 6, true, "main"}}) ==
          Rows{"abcdef", "^^^^^^ main", "|", "other"});
    CHECK(rows("abc", {{0, 1, false, "one"}, {0, 1, false, "two"}, {2, 3, true, "main"}}) ==
          Rows{"abc", "- ^ main", "|", "one", "two"});
}

TEST_CASE("a text cannot break out of its row") {
    CHECK(rows("ab", {{0, 2, true, "one\ntwo\x1b"}}) == Rows{"ab", "^^ one␊two␛"});
    CHECK(rows("ab", {{0, 1, true, "\n"}, {1, 2, false, "x"}}) == Rows{"ab", "^- x", "|", "␊"});
}

TEST_CASE("a long line is cut to what is marked") {
    const std::string exactly = times(max_columns, "x");
    CHECK(rows(exactly, {{0, 1, true, ""}})[0] == exactly);
    CHECK(rows(exactly + "x", {{0, 1, true, ""}})[0] == times(99, "x") + "…");
    CHECK(rows(exactly + "x", {})[0] == times(99, "x") + "…");

    const std::string line = times(5000, "é") + "HERE" + times(5000, "z");
    CHECK(rows(line, {{10000, 10004, true, "this"}}) ==
          Rows{"…" + times(47, "é") + "HERE" + times(47, "z") + "…", times(48, " ") + "^^^^ this"});
    CHECK(rows(line, {{0, 2, true, ""}}) == Rows{times(99, "é") + "…", "^"});
    const std::size_t end = line.size();
    CHECK(rows(line, {{end - 1, end, true, ""}}) ==
          Rows{"…" + times(99, "z"), times(99, " ") + "^"});
    CHECK(rows(line, {{end, end, true, ""}}) == Rows{"…" + times(99, "z"), times(100, " ") + "^"});
    CHECK(
        rows(line, {{10004, end, true, ""}}) ==
        Rows{"…" + times(5, "é") + "HERE" + times(89, "z") + "…", times(10, " ") + times(90, "^")});
}

TEST_CASE("marks outside a cut line stay at its edges") {
    const std::string line = times(500, "a") + "HERE" + times(500, "z");
    CHECK(
        rows(line,
             {{500, 504, true, ""}, {0, 5, false, "far left"}, {1000, 1004, false, "far right"}}) ==
        Rows{"…" + times(47, "a") + "HERE" + times(47, "z") + "…",
             "-" + times(47, " ") + "^^^^" + times(47, " ") + "- far right", "|", "far left"});
}

TEST_CASE("a line of many megabytes is shown at once") {
    const std::string line(50'000'000, '\t');
    CHECK(rows(line, {{25'000'000, 25'000'001, true, "here"}})[1].ends_with("^^^^ here"));
}

TEST_CASE("colours surround the marks and change nothing else") {
    const Palette colours = palette(Severity::error, true);
    const MarkedLine shown = marked_line("ab cd", {{0, 2, false, "x"}, {3, 5, true, "y"}}, colours);
    CHECK(shown.source == "ab cd");
    CHECK(shown.below == Rows{"\x1b[1;34m--\x1b[0m \x1b[1;31m^^\x1b[0m \x1b[1;31my\x1b[0m",
                              "\x1b[1;34m|\x1b[0m", "\x1b[1;34mx\x1b[0m"});
}

}  // namespace candelabra
