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
