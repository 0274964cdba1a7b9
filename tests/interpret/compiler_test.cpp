// SPDX-License-Identifier: GPL-3.0-or-later
// Programs compute the same values as walks: each expression is evaluated three times in a loop,
// and once alone.
#include "interpret/compiler.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::string setting =
    "#declare a = 2; #declare b = -0.75; #declare u2 = <3, 4>; #declare p = <1, -2, 3>; "
    "#declare w = <0.5, 4, -1>; #declare q = <1, 2, 3, 4>; #declare c = rgbft <.1, .2, .3, .4, "
    ".5>; "
    "#declare A = array[3] {4, 5, 6}; #declare B = array[2][2] {{x, y}, {z, <1, 2, 3>}}; ";

/// Compares the results with all their digits.
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

TEST_CASE("operators are compiled as they are walked", "[interpret]") {
    for (const std::string a : {"a", "b", "u2", "p", "q", "c", "0", "A[1]", "B[1][0]"})
        for (const std::string b : {"a", "b", "u2", "w", "q", "c", "1", "A[a]", "B[1][1]"})
            for (const std::string sign :
                 {"+", "-", "*", "/", "<", "<=", "=", "!=", ">=", ">", "&", "|"})
                check_same("(" + a + " " + sign + " " + b + ")");
}

TEST_CASE("other expressions are compiled as they are walked", "[interpret]") {
    check_same(GENERATE(
        as<std::string>(), "-p", "!b", "+a", "!<0, 1e-11, 1>", "(a > 1 ? p : w)", "(a < 1 ? p : w)",
        "(a ? 1 : 2) + (b < 0 ? 3 : 4)", "p.x + c.transmit", "c.gray", "u2.gray", "<a, b, a + b>",
        "<a, b>", "<a, b, 1, 2, 3> * 2", "rgb a", "rgb p", "rgbf q", "rgbt q", "rgbt 0.5",
        "rgbft c", "rgbt c", "rgb c", "srgb p", "((a + (b)))", "pi * a + x.x", "t * a", "a / 0.3",
        "a / b / p", "(a = 2 & b < 0 | a > 5)", "(1e-11 * a = 0)", "<1, 2, 3>.y * -a",
        "version + a", "on + clock + a", "a - 0.1 - 0.2 + 7 * 0.1", "-(a * -b)"));
}

TEST_CASE("calls are compiled as they are walked", "[interpret]") {
    const auto expression = GENERATE(
        as<std::string>(), "abs(b)", "acos(b)", "acosh(a)", "asin(b)", "asinh(b)", "atan(b)",
        "atanh(b)", "ceil(b)", "cos(b)", "cosh(b)", "degrees(b)", "exp(b)", "floor(b)",
        "int(b * 10)", "ln(a)", "log(a)", "radians(b)", "sin(b)", "sinh(b)", "sqrt(a)", "tan(b)",
        "tanh(b)", "atan2(a, b)", "atan2(0, b)", "div(a * 10, 3)", "div(a, 0)", "mod(a * 10, 3)",
        "mod(b, 0.2)", "mod(-a, 2)", "pow(a, b)", "pow(b, 2)", "pow(0, a)", "min(a)", "min(a, b)",
        "max(a, b, 5)", "min(3, b, a, -7)", "select(b, 1, 2)", "select(a, 1, 2)", "select(0, 1, 2)",
        "select(b, 1, 2, 3)", "select(a, 1, 2, 3)", "select(a - 2, 1, 2, 3)", "vdot(p, w)",
        "vdot(a, w)", "vdot(<1, 2>, w)", "vcross(p, w)", "vlength(p)", "vlength(a)",
        "vnormalize(p)", "vnormalize(p * a)", "vrotate(p, w * 50)", "vaxis_rotate(p, w, 30)",
        "dimension_size(A, a)", "dimension_size(A, 9)", "dimensions(A)", "A[0] + A[1][0]",
        "A[b + 1][0.5 * a]", "sin(a > 1)", "bitwise_and(6, a)", "strlen(\"abc\") + a",
        "val(\"2\") * a", "trace(O, -9*z, z)", "trace(O, <a, 9, -9>, p)", "trace(O, 9*p, -p, w)",
        "trace(O, 9*p, -p, w) + w", "trace(O, 9*p, -p, w).y", "trace(O, p, p - p)",
        "trace(O, p, a, b)", "trace(O, p, p, A[0][0])", "trace(b, p, p)", "inside(O, p/9)",
        "inside(O, b)", "inside(Open, p)", "inside(O, <1, 2, 3, 4>)", "inside(O, p, p)");
    INFO(expression);
    const std::string setting =
        "#declare a = 2; #declare b = -0.75; #declare p = <1, -2, 3>; #declare w = <0.5, 4, -1>; "
        "#declare A = array[3][2] {{4, 5}, {6, 7}, {8, 9}}; "
        "#declare O = sphere { 0, 1.5 } #declare Open = triangle { 0, x, y } ";
    const std::string shown =
        "#debug vstr(5, r, \",\", 0, 17) #debug vstr(5, w, \",\", 0, 17) #debug \"\\n\" ";
    const Said walked = said(setting + "#declare r = " + expression + "; " + shown);
    const Said run =
        said(setting + "#for (i, 1, 3) #declare r = " + expression + "; #end " + shown);
    CHECK(walked.messages == run.messages);
    CHECK(walked.printed == run.printed);
    CHECK(walked.printed.ends_with("\n"));
}

TEST_CASE("a random number is drawn once for each call", "[interpret]") {
    CHECK(printed("#declare R = seed(0); #for (i, 1, 3) #declare p = <rand(R), rand(R), rand(R)>; "
                  "#end V(3, p)") == "<0.4337,0.0385,0.3087>");
}

}  // namespace candelabra
