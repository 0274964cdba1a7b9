// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/constants.h"

#include "syntax/parser.h"
#include "text/source.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct Parsed {
    explicit Parsed(const std::string& text)
        : tree(parse(sources.add("main.pov", text), sources, names, diagnostics)) {
        REQUIRE(!diagnostics.failed());
    }

    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    Tree tree;
};

}  // namespace

TEST_CASE("what is made of numbers and words only is constant", "[reading]") {
    const std::string script =
        GENERATE(as<std::string>(), "sphere { 0, 1 }", "pigment { rgb 1 }",
                 "pigment { checker rgb <1, .5, 0> rgbf 1 scale 2 }",
                 "finish { ambient -pi/2 reflection { 0.1, 1 fresnel on } }",
                 "box { <1, 2, (3 + 4)>.x, y*2 rotate 30*clock no_shadow }",
                 "pigment { color red 1 green 0.5 }", "texture { } texture { }",
                 "union { sphere { 0, 1 } cylinder { 0, (1 ? y : x), 1 } }");
    const Parsed parsed(script);
    INFO(script);
    CHECK(is_constant(parsed.tree, parsed.tree.first));
}

TEST_CASE("names, calls and directives may mean something else the next time", "[reading]") {
    const std::string script =
        GENERATE(as<std::string>(), "sphere { A, 1 }", "sphere { 0, rand(R) }", "pigment { Red }",
                 "sphere { 0, A[0] }", "pigment { #if (1) rgb 1 #end }", "union { M(1) }",
                 "sphere { 0, version }", "sphere { 0, now }", "sphere { 0, <1, A, 2>.x }",
                 "#declare A = 1;");
    const Parsed parsed(script);
    INFO(script);
    CHECK_FALSE(is_constant(parsed.tree, parsed.tree.first));
}

TEST_CASE("what is too large to be looked through is not called constant", "[reading]") {
    std::string script = "union { ";
    for (int i = 0; i < 200; ++i) script += "sphere { 0, 1 } ";
    const Parsed parsed(script + "}");
    CHECK_FALSE(is_constant(parsed.tree, parsed.tree.first));
}

TEST_CASE("a constant element has a number from the second time on", "[reading]") {
    const Parsed parsed("sphere { 0, 1 } sphere { A, 1 }");
    const NodeId first = parsed.tree.first, second = parsed.tree[first].next;
    const auto element = [&](NodeId node) {
        Element result;
        result.origin = {&parsed.tree, node};
        return result;
    };
    Constants constants;
    CHECK_FALSE(constants.number(element(first)));
    const auto number = constants.number(element(first));
    REQUIRE(number);
    CHECK(constants.number(element(first)) == number);
    for (int i = 0; i < 3; ++i) CHECK_FALSE(constants.number(element(second)));
    CHECK_FALSE(constants.number(Element()));
}

TEST_CASE("names may be allowed, and are then told", "[reading]") {
    const Parsed parsed("texture { T scale S*2 }");
    std::vector<NameId> names;
    CHECK(is_constant_but_names(parsed.tree, parsed.tree.first, names));
    CHECK(names.size() == 2);
    const Parsed call("texture { T scale F(2) }");
    CHECK_FALSE(is_constant_but_names(call.tree, call.tree.first, names));
}

}  // namespace candelabra
