// SPDX-License-Identifier: GPL-3.0-or-later
// Programs give what a walk gives: each expression is evaluated three times in a loop, and once
// alone.
#include "evaluate/compiler.h"

#include "evaluate/said.h"

#include <catch2/catch.hpp>

namespace {

const std::string setting =
    "#declare a = 2; #declare b = -0.75; #declare u2 = <3, 4>; #declare p = <1, -2, 3>; "
    "#declare w = <0.5, 4, -1>; #declare q = <1, 2, 3, 4>; #declare c = rgbft <.1, .2, .3, .4, "
    ".5>; "
    "#declare A = array[3] {4, 5, 6}; #declare B = array[2][2] {{x, y}, {z, <1, 2, 3>}}; ";

/// Both must be printed with all their digits.
void check_same(const std::string& expression) {
    INFO(expression);
    const auto shown = [](const std::string& name) {
        return "#debug vstr(5, " + name + ", \",\", 0, 17) #debug \"\\n\" ";
    };
    const std::string once = setting + "#declare r = " + expression + "; " + shown("r");
    const std::string often =
        setting + "#for (i, 1, 3) #declare r = " + expression + "; #end " + shown("r");
    const Said walked = said(once), run = said(often);
    CHECK(walked.messages == run.messages);
    CHECK(walked.printed == run.printed);
    CHECK(walked.printed.ends_with("\n"));
}

}  // namespace

TEST_CASE("operators are compiled as they are walked", "[evaluate]") {
    for (const std::string a : {"a", "b", "u2", "p", "q", "c", "0", "A[1]", "B[1][0]"})
        for (const std::string b : {"a", "b", "u2", "w", "q", "c", "1", "A[a]", "B[1][1]"})
            for (const std::string sign :
                 {"+", "-", "*", "/", "<", "<=", "=", "!=", ">=", ">", "&", "|"})
                check_same("(" + a + " " + sign + " " + b + ")");
}

TEST_CASE("other expressions are compiled as they are walked", "[evaluate]") {
    check_same(GENERATE(
        as<std::string>(), "-p", "!b", "+a", "!<0, 1e-11, 1>", "(a > 1 ? p : w)", "(a < 1 ? p : w)",
        "(a ? 1 : 2) + (b < 0 ? 3 : 4)", "p.x + c.transmit", "c.gray", "u2.gray", "<a, b, a + b>",
        "<a, b>", "<a, b, 1, 2, 3> * 2", "rgb a", "rgb p", "rgbf q", "rgbt q", "rgbt 0.5",
        "rgbft c", "rgbt c", "rgb c", "srgb p", "((a + (b)))", "pi * a + x.x", "t * a", "a / 0.3",
        "a / b / p", "(a = 2 & b < 0 | a > 5)", "(1e-11 * a = 0)", "<1, 2, 3>.y * -a",
        "version + a", "on + clock + a", "a - 0.1 - 0.2 + 7 * 0.1", "-(a * -b)"));
}
