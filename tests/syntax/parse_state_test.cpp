// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/parse_state.h"

#include "syntax/parsed.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("nodes are made in their simplest form", "[syntax]") {
    const auto [text, tree] = GENERATE(table<std::string, std::string>({
        {"-1", "number -1\n"},
        {"-(1)", "unary -\n  group\n    number 1\n"},
        {"<1 /* a */, -2, 3>", "literal 1 -2 3\n"},
        {"<1, 2, 3, 4, 5, 6>",
         "vector\n  number 1\n  number 2\n  number 3\n  number 4\n  number 5\n  number 6\n"},
        {"(1)", "group\n  number 1\n"},
        {"(1, 2)", "tuple\n  number 1\n  number 2\n"},
        {"#declare T = texture { A };",
         "#declare with ;\n  target: name T\n  value: block texture\n    name A\n"},
        {"#declare T = texture { A } texture { B }",
         "#declare\n  target: name T\n  value: layers\n    block texture\n      name A\n    block "
         "texture\n      name B\n"},
        {"#local a = 1;", "#local with ;\n  target: name a\n  value: number 1\n"},
        {"rgb 1 filter 2 transmit 3",
         "colour\n  base: rgb\n    number 1\n  channels: channel filter\n    number 2\n  channels: "
         "channel transmit\n    number 3\n"},
        {"color red 1 green 2",
         "colour\n  channels: channel red\n    number 1\n  channels: channel green\n    number "
         "2\n"},
        {"#macro M(a, optional b) #end",
         "#macro M\n  parameters: parameter a\n  parameters: parameter b, optional\n"},
        {"#macro M(optional, b) #end",
         "#macro M\n  parameters: parameter optional\n  parameters: parameter b\n"},
        {"function { pattern { marble } }", "function\n  body: block pattern\n    word marble\n"},
    }));
    INFO(text);
    const Parsed parsed(text);
    CHECK(parsed.messages() == "");
    CHECK(parsed.dumped() == tree);
}

TEST_CASE("two commas in a row are wrong", "[syntax]") {
    CHECK(Parsed("box { 1,, 2 }").messages() == "1:9 error: two commas in a row\n");
    CHECK(Parsed("box { 1, #if (a) , #end 2 }").messages() == "");
}

TEST_CASE("a lone semicolon is only a warning", "[syntax]") {
    CHECK(Parsed("box { };").messages() == "1:8 warning: this `;` has no effect\n");
}

}  // namespace candelabra
