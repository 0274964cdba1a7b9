// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that broke a law once: those of mended faults hold.
#include "base/deep_stack.h"
#include "proof/runner.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace candelabra::proof {

namespace {

namespace fs = std::filesystem;

std::string text_of_file(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("scenes that broke a law before it was mended hold", "[proof]") {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(CANDELABRA_SOURCE_DIR "/tests/proof/cases"))
        files.push_back(entry.path());
    std::ranges::sort(files);
    CHECK(files.size() > 5);
    on_deep_stack(std::size_t{64} << 20, [&](std::size_t) {
        for (const fs::path& file : files) {
            const std::string text = text_of_file(file);
            const auto found = case_of(text);
            INFO(file);
            REQUIRE(found);
            if (text.find("// open\n") != text.npos) continue;  // not mended yet
            const Verdict verdict = judged(*found->law, found->script, found->seed, {});
            INFO(described(verdict));
            CHECK(verdict.outcome == Outcome::holds);
        }
    });
}

}  // namespace candelabra::proof
