// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/element.h"

#include "proof/changes.h"
#include "proof/runner.h"
#include "proof/shrink.h"

#include <catch2/catch.hpp>

namespace candelabra::proof {

namespace {

Script two_lamps() {
    Script script;
    script.lights = 2;
    script.elements = {
        of_light(0, block("sphere", "0, 1",
                          {block("finish", "emission @2@ $no_luminaire$"), words("scale 2")})),
        of_light(1, block("light_source", "y, rgb @0.5@*<1, 0, 0>")),
        block("sky_sphere", "pigment { rgb 1 } $luminaire$")};
    return script;
}

/// The text with one blank in the place of several.
std::string tokens(const std::string& text) {
    std::string result;
    for (const char c : text)
        if (const bool blank = c == ' ' || c == '\n'; !blank || !result.ends_with(' '))
            result += blank ? ' ' : c;
    return result;
}

}  // namespace

TEST_CASE("shapes, combinations and models are objects, which laws move", "[proof]") {
    for (const char* head : {"sphere", "union", "model", "light_source", "object"})
        CHECK(is_object(block(head, "")));
    for (const char* head : {"camera", "texture", "#default", "background"})
        CHECK_FALSE(is_object(block(head, "")));
}

TEST_CASE("amounts of light are written with the factor of their light", "[proof]") {
    const Element lamp = two_lamps().elements[0], source = two_lamps().elements[1];
    CHECK(written(lamp, {.light = 3}).find("emission 6 ") != std::string::npos);
    CHECK(written(lamp, {.only = 1}).find("emission 0 ") != std::string::npos);
    CHECK(written(source, {.light = 3, .only = 1}).find("rgb 1.5*") != std::string::npos);
}

TEST_CASE("words say how lamps are found", "[proof]") {
    const std::string sampled = written(two_lamps());
    const std::string chance = written(two_lamps(), {.found = Found::by_chance});
    CHECK(sampled.find("no_luminaire") == std::string::npos);
    CHECK(sampled.find("luminaire") != std::string::npos);
    CHECK(chance.find("no_luminaire") != std::string::npos);
    CHECK(chance.find(" luminaire") == std::string::npos);
}

TEST_CASE("a marked text makes the same scenes again", "[proof]") {
    const Script script = two_lamps();
    const Script again = script_of(written(script, {.marked = true}));
    CHECK(again.lights == 2);
    for (const Writing& writing : {Writing{}, Writing{.light = 3}, Writing{.only = 0},
                                   Writing{.only = 1}, Writing{.found = Found::by_chance}})
        CHECK(tokens(written(again, writing)) == tokens(written(script, writing)));
}

TEST_CASE("shrinking keeps what the fault needs, and no more", "[proof]") {
    Script script = two_lamps();
    script.elements.push_back(
        block("union", "", {block("box", "0, 1", {words("hollow")}), block("torus", "1, 0.2")}));
    const Script small = shrunk(script, [](const Script& smaller) {
        return written(smaller).find("hollow") != std::string::npos;
    });
    REQUIRE(small.elements.size() == 1);
    CHECK(written(small).find("union") == std::string::npos);
    CHECK(written(small).find("torus") == std::string::npos);
    CHECK(written(small).find("hollow") != std::string::npos);
}

TEST_CASE("a text whose braces do not match is told so, and read without a crash", "[proof]") {
    const std::string begin = "// a brace { in a comment\nsphere { 0, 1\npigment { rgb \"}\"";
    CHECK(trouble_with_braces(begin + " } }") == "");
    CHECK(trouble_with_braces(begin + " }") == "the `{` in line 2 has no `}`");
    CHECK(trouble_with_braces(begin) == "the `{` in line 3 has no `}`");
    CHECK(trouble_with_braces(begin + " } }\n}") == "the `}` in line 4 has no `{`");
    CHECK(trouble_with_braces(begin + "\"") == "a string has no end");
    for (const char* end : {" } }", " }", "", " } }\n}", "\"", "{", "{{{"})
        CHECK_FALSE(script_of(begin + end).elements.empty());
}

TEST_CASE("a case is read as it was written", "[proof]") {
    Script script = two_lamps();
    script.options = {{3, 0.5}};
    const auto read = case_of(case_text(laws().front(), 7, script, "figures"));
    REQUIRE(read);
    CHECK(read->law == &laws().front());
    CHECK(read->seed == 7);
    CHECK(read->script.options == script.options);
    CHECK(tokens(written(read->script)) == tokens(written(script)));
}

}  // namespace candelabra::proof
