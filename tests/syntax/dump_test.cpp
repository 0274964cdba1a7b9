// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/dump.h"

#include "syntax/parsed.h"

#include <catch2/catch.hpp>

TEST_CASE("a tree is dumped a node a line", "[syntax]") {
    CHECK(Parsed("#macro M(a) sphere { A[1], a * 2 } #end M(\"s\")").dumped() ==
          "#macro M\n"
          "  parameters: parameter a\n"
          "  body: block sphere\n"
          "    index A\n"
          "      at: number 1\n"
          "    binary *\n"
          "      left: name a\n"
          "      right: number 2\n"
          "call M\n"
          "  with: text \"s\"\n");
}

TEST_CASE("what is nested deeper than anybody reads tells its depth as a number", "[syntax]") {
    const std::size_t depth = 20000;
    const std::string text =
        Parsed("#declare A = " + std::string(depth, '(') + "1" + std::string(depth, ')') + ";")
            .dumped();
    CHECK(text.find("\n" + std::string(200, ' ') + "group\n") != text.npos);
    CHECK(text.find(" (101 deep) group\n") != text.npos);
    CHECK(text.ends_with("deep) number 1\n"));
    CHECK(text.size() < 300 * depth);
}
