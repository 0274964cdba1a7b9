// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/nearest.h"

#include <catch2/catch.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

using Names = std::vector<std::string_view>;

TEST_CASE("the nearest name is found, and nothing where nothing is near") {
    const Names names = {"sphere",  "superellipsoid", "box",       "torus",     "color",
                         "pigment", "no_shadow",      "translate", "transform", "x"};
    struct Case {
        std::string_view word;
        std::string expected;
    };
    const Case cases[] = {
        {"shpere", "sphere"},   // swapped
        {"spere", "sphere"},    // left out
        {"spheree", "sphere"},  // added
        {"sphare", "sphere"},   // changed
        {"SPHERE", "sphere"},   // case
        {"Shpere", "sphere"},   // case and swapped
        {"bax", "box"},
        {"colour", "color"},
        {"noshadow", "no_shadow"},
        {"superelipsiod", "superellipsoid"},
        {"SUPERELLIPSOID", "superellipsoid"},
        {"translat", "translate"},
        {"X", "x"},
        {"y", ""},  // short words attract nothing
        {"bo", "box"},
        {"pig", "pigment"},  // not written to its end
        {"Superell", "superellipsoid"},
        {"trans", ""},
        {"no", ""},
        {"banana", ""},
        {"", ""},
    };
    for (const Case& each : cases) {
        CAPTURE(each.word);
        CHECK(nearest(each.word, names) == each.expected);
    }
}

TEST_CASE("case decides only between names that are equally near") {
    CHECK(nearest("red", {"Red", "rad"}) == "Red");
    CHECK(nearest("Rod", {"red", "Red"}) == "Red");
    CHECK(nearest("rod", {"rad", "red"}) == "rad");
}

TEST_CASE("a difference in case does not buy another slip") {
    CHECK(nearest("SUPERELLIPSOIDxx", {"superellipsoid"}) == "superellipsoid");
    CHECK(nearest("abcdefghijkl", {"ABCDEFGHwxyz"}) == "");
    CHECK(nearest("abcdefghijkl", {"ABCDEFGHIxyz"}) == "ABCDEFGHIxyz");
}

TEST_CASE("few names: the nearest first, each once, no more than asked for") {
    const Names names = {"rotate", "rotated", "rotates", "rotate", "scale", "rotatte"};
    CHECK(nearest_few("rotate", names) == std::vector<std::string>{"rotate", "rotated", "rotates"});
    CHECK(nearest_few("rotate", names, 1) == std::vector<std::string>{"rotate"});
    CHECK(nearest_few("rotate", names, 9).size() == 4);
    CHECK(nearest_few("rotate", names, 0).empty());
    CHECK(nearest_few("pigment", names).empty());
    CHECK(nearest_few("pigment", {}).empty());
}

TEST_CASE("words without end are no misspelt names") {
    const std::string endless(1'000'000, 'a');
    const std::string other = endless + "b";
    CHECK(nearest(endless, {other, "box", ""}) == "");
    const std::string longest(64, 'a');
    const std::string near = std::string(63, 'a') + "b";
    CHECK(nearest(longest, {near}) == near);
}

}  // namespace candelabra
