// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/evaluator.h"

#include "evaluate/said.h"

#include <algorithm>
#include <catch2/catch.hpp>

TEST_CASE("nothing is evaluated when the text has errors", "[evaluate]") {
    const Said result = said("#debug \"a\" box { ");
    CHECK(result.printed == "");
    CHECK(result.messages == "error: `{` has no end\n");
}

TEST_CASE("after too many errors evaluation ends", "[evaluate]") {
    const Said result =
        said("#for (i, 1, 1000) #declare a = i / nope; #declare b = A[i]; #end #debug \"end\"");
    CHECK(result.messages ==
          "error: nothing is declared as `nope`\nerror: nothing is declared as `A`\n");
    std::string many;
    for (int i = 0; i < 50; ++i) many += "#declare a = nope" + std::to_string(i) + ";\n";
    const Said stopped = said(many + "#debug \"end\"");
    CHECK(std::count(stopped.messages.begin(), stopped.messages.end(), '\n') == 20);
    CHECK(stopped.printed == "");
}

TEST_CASE("a misspelt name is guessed", "[evaluate]") {
    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    const Loader loader([](const std::string&) { return std::nullopt; });
    Evaluator evaluator(sources, loader, names, diagnostics);
    evaluator.run(sources.add("main.pov", "#declare Radius = 1; #declare a = Raduis + 1;"));
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all()[0].help == "did you mean `Radius`?");
}

TEST_CASE("elements become values", "[evaluate]") {
    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    const Loader loader([](const std::string&) { return std::nullopt; });
    Evaluator evaluator(sources, loader, names, diagnostics);
    Meaning meaning;
    std::vector<std::string> kinds;
    meaning.value = [](std::span<const Element> blocks) {
        return Value(static_cast<double>(blocks.size()));
    };
    meaning.set_default = [](const Element&) {};
    meaning.print = [](std::string_view) {};
    meaning.top = [&](const Element& element) {
        kinds.emplace_back(kind_name(evaluator.value_of(element)));
    };
    evaluator.set_meaning(meaning);
    evaluator.declare("depth", 3.0);
    evaluator.run(sources.add("main.pov", "depth \"s\" sphere { } rgb 1 array[2]"));
    CHECK(kinds ==
          std::vector<std::string>{"a number", "a string", "a number", "a colour", "an array"});
    CHECK_FALSE(diagnostics.failed());
    CHECK(evaluator.spelling(names.find("depth")) == "depth");
}
