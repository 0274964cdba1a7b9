// SPDX-License-Identifier: GPL-3.0-or-later
// The lines in grammar/cases, a file for each production: what it accepts (+) and what it rejects
// (-).
#include "syntax/parsed.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace candelabra {

namespace {

const std::filesystem::path grammar = std::filesystem::path(CANDELABRA_SOURCE_DIR) / "grammar";

std::set<std::string> productions() {
    std::ifstream file(grammar / "scene.yy");
    std::set<std::string> names;
    const std::regex head(R"(^(\w+):( .*)?$)");
    bool rules = false;
    for (std::string line; std::getline(file, line);) {
        std::smatch match;
        if (line == "%%") rules = true;
        if (rules && std::regex_match(line, match, head)) names.insert(match[1]);
    }
    return names;
}

}  // namespace

TEST_CASE("each production has its cases", "[grammar]") {
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(grammar / "cases"))
        files.insert(entry.path().filename().string());
    REQUIRE(files.size() > 40);
    CHECK(files == productions());
}

TEST_CASE("the grammar accepts and rejects what its cases say", "[grammar]") {
    for (const auto& entry : std::filesystem::directory_iterator(grammar / "cases")) {
        std::ifstream file(entry.path());
        int accepted = 0, rejected = 0;
        for (std::string line; std::getline(file, line);) {
            INFO(entry.path().filename().string() << ": " << line);
            const Parsed parsed(line.size() > 2 ? line.substr(2) : std::string());
            INFO(parsed.messages());
            CHECK(parsed.diagnostics.failed() == (line[0] == '-'));
            ++(line[0] == '-' ? rejected : accepted);
        }
        INFO(entry.path().filename().string());
        CHECK(accepted > 0);
        CHECK(rejected > 0);
    }
}

}  // namespace candelabra
