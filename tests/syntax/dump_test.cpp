// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/dump.h"

#include "syntax/parsed.h"

#include <catch2/catch.hpp>

namespace candelabra {

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

TEST_CASE("tokens are dumped with place, kind and text", "[syntax]") {
    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    CHECK(dump_tokens(sources.add("test", "box {\n 1 }"), sources, names, diagnostics) ==
          "1:1 word box\n1:5 { {\n2:2 number 1\n2:4 } }\n");
    CHECK(dump_tokens(sources.add("test", "\n  1 /* \xC3\xB6\n\xC3\xB6 */ 2 /*\xC3\xB6*/ 3"),
                      sources, names,
                      diagnostics) == "2:3 number 1\n3:6 number 2\n3:14 number 3\n");
}

}  // namespace candelabra
