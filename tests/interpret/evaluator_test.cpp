// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/evaluator.h"

#include "interpret/said.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("nothing is evaluated when the text has errors", "[interpret]") {
    const Said result = said("#debug \"a\" box { ");
    CHECK(result.printed == "");
    CHECK(result.messages == "error: `{` has no end\n");
}

TEST_CASE("after too many errors evaluation ends", "[interpret]") {
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

TEST_CASE("a misspelt name is guessed", "[interpret]") {
    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    const Loader loader([](const std::string&) { return std::nullopt; });
    Evaluator evaluator(sources, loader, names, diagnostics);
    evaluator.run(sources.add("main.pov", "#declare Radius = 1; #declare a = Raduis + 1;"));
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all()[0].help == "did you mean `Radius`?");
}

TEST_CASE("elements become values", "[interpret]") {
    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    const Loader loader([](const std::string&) { return std::nullopt; });
    Evaluator evaluator(sources, loader, names, diagnostics);
    ElementHandlers handlers;
    std::vector<std::string> kinds;
    handlers.value = [](std::span<const Element> blocks) {
        return Value(static_cast<double>(blocks.size()));
    };
    handlers.set_default = [](const Element&) {};
    handlers.print = [](std::string_view) {};
    handlers.top = [&](const Element& element) {
        kinds.emplace_back(kind_name(evaluator.value_of(element)));
    };
    evaluator.set_handlers(handlers);
    evaluator.declare("depth", 3.0);
    evaluator.run(sources.add("main.pov", "depth \"s\" sphere { } rgb 1 array[2]"));
    CHECK(kinds ==
          std::vector<std::string>{"a number", "a string", "a number", "a colour", "an array"});
    CHECK_FALSE(diagnostics.failed());
    CHECK(evaluator.spelling(names.find("depth")) == "depth");
}

}  // namespace candelabra
