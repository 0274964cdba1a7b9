// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/textmate.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <regex>

namespace candelabra {

namespace {

/// Returns the scope that the grammar gives to the first word of a line without comments and
/// strings. Patterns are tried in order, as editors do.
std::string scope_of(const std::string& line) {
    const auto grammar = nlohmann::json::parse(textmate_grammar());
    for (const auto& pattern : grammar["patterns"]) {
        if (!pattern.contains("match")) continue;
        const std::regex match(pattern["match"].get<std::string>());
        if (std::regex_search(line, match, std::regex_constants::match_continuous))
            return pattern.value("name", "macro");
    }
    return "";
}

}  // namespace

TEST_CASE("each class of words has its colour") {
    struct Case {
        const char *line, *scope;
    };
    const Case cases[] = {
        {"sphere {", "keyword.other.pov"},
        {"light_octree", "keyword.other.pov"},
        {"rgbft <1", "support.type.colour.pov"},
        {"vrotate(", "support.function.pov"},
        {"pi", "constant.language.pov"},
        {"1.5e-3", "constant.numeric.pov"},
        {"#declare", "keyword.control.directive.pov"},
        {"# while", "keyword.control.directive.pov"},
        {"#macro M(", "macro"},
        {"array[3]", "storage.type.pov"},
        {"// sphere", "comment.line.double-slash.pov"},
        {"Sphere", ""},
        {"spheres", ""},
        {"declare", ""},
    };
    for (const Case& each : cases) {
        CAPTURE(each.line);
        CHECK(scope_of(each.line) == each.scope);
    }
}

}  // namespace candelabra
