// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/lint.h"

#include "syntax/parser.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string unused(const std::string& text) {
    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    const Tree tree = parse(sources.add("test.pov", text), sources, names, diagnostics);
    lint(tree, names, diagnostics);
    std::string found;
    for (const Diagnostic& each : diagnostics.all()) {
        CHECK(each.fault == Fault::unused_parameter);
        found += text.substr(each.span.first, each.span.last - each.span.first) + ' ';
    }
    return found;
}

}  // namespace

TEST_CASE("parameters that a macro does not name", "[lint]") {
    struct Case {
        const char* text;
        const char* unused;
    };
    const auto [text, expected] = GENERATE(values<Case>({
        {"#macro M(A, B) sphere { A, 1 } #end", "B "},
        {"#macro M(A, B) #end", ""},
        {"#macro M(A, B) 1 #end", "A B "},
        {"#macro M(A) #if (1) #local C = 2 * A; #end #end", ""},
        {"#macro M(A) A[1] #end", ""},
        {"#macro M(F) F(1) #end", ""},
        {"#macro M(T) #macro N(U) T #end #end", "U "},
        {"#declare A = 1; #macro M(A) 1 #end A", "A "},
        {"#macro M() #end", ""},
    }));
    INFO(text);
    CHECK(unused(text) == expected);
}

}  // namespace candelabra
