// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/variation.h"

#include "interpret/evaluator.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The result of Variable::find for the block that is the third element of a file.
struct Finding {
    explicit Finding(const std::string& block, std::size_t values) {
        Diagnostics diagnostics;
        SourceStore sources;
        const Loader loader([](const std::string&) { return std::nullopt; });
        Names names;
        Evaluator evaluator(sources, loader, names, diagnostics);
        ElementHandlers handlers;
        handlers.top = [&](const Element& element) {
            for (int i = 0; i < 9; ++i) {
                if (!variable) variable = Variable::find(evaluator, element.body, values);
                if (!variable) return;
                evaluator.begin_attempt();
                if (!variable->compute(evaluator, element.body, variation.emplace()))
                    variation.reset();
                evaluator.end_attempt(false);
            }
        };
        evaluator.set_handlers(std::move(handlers));
        const std::string script = "#declare R = seed(1); #declare I = 3; sphere { " + block + " }";
        evaluator.run(sources.add("main.pov", script));
    }

    std::optional<Variable> variable;
    std::optional<Variation> variation;
};

}  // namespace

TEST_CASE("what may differ in a block is found", "[reading]") {
    struct Case {
        const char* block;
        bool known, coloured, moved;
    };
    const auto [block, known, coloured, moved] = GENERATE(values<Case>({
        {"I, 1", true, false, false},
        {"I", false, false, false},
        {"I, 1 #if (I) #end", false, false, false},
        {"I, 1 pigment { rgb 1 }", true, false, false},
        {"I, 1 pigment { rgb I }", true, true, false},
        {"I, 1 pigment { rgb I filter 1 }", true, false, false},
        {"I, 1 pigment { rgb rand(R) } scale 2", true, true, false},
        {"I, 1 texture { pigment { rgb I } finish { phong 1 } } translate I", true, true, true},
        {"I, 1 texture { pigment { rgb I } pigment { rgb I } }", false, false, false},
        {"I, 1 pigment { rgb I } pigment { rgb 1 }", false, false, false},
        {"I, 1 pigment { rgb 1 } pigment { rgb I }", false, false, false},
        {"I, 1 translate I rotate 2*I*y", true, false, true},
        {"I, 1 scale 2 no_shadow translate I", false, false, false},
        {"I, 1 hollow translate I", true, false, true},
        {"I, 1 translate I hollow", true, false, false},
    }));
    INFO(block);
    const Finding found(block, 2);
    REQUIRE(found.variable.has_value() == known);
    if (!known) return;
    CHECK(found.variable->coloured() == coloured);
    CHECK(found.variable->moved() == moved);
    CHECK(found.variable->plain() == (!coloured && !moved));
}

TEST_CASE("what differs is computed, unless it is unusual", "[reading]") {
    const Finding found("I*x, 2 pigment { rgb <I, 0, 1> } translate I*y rotate 90*z", 2);
    REQUIRE(found.variation);
    CHECK(found.variation->count == 2);
    CHECK(found.variation->values[0] == Numbers::vector(Vec3(3, 0, 0)));
    CHECK(found.variation->colour.rgb == Rgb(3, 0, 1));
    CHECK(length(found.variation->movement->point(Vec3(0)) - Vec3(-3, 0, 0)) < 1e-12);
    for (const char* block : {"Q, 1", "I, 1 pigment { rgb Q }", "I, 1 scale I - 3",
                              "I, 1 translate <I, I, I, I>", "I, 1 pigment { rgb 1/(I - 3) }"}) {
        INFO(block);
        CHECK_FALSE(Finding(block, 2).variation);
    }
}

}  // namespace candelabra
