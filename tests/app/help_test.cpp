// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help.h"

#include "app/option_table.h"
#include "support/shell.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace {

std::string help(std::string_view topic) {
    Diagnostics diagnostics;
    std::string text = help_text(topic, diagnostics);
    for (const Diagnostic& each : diagnostics.all())
        text += "! " + each.message + " | " + each.help;
    return text;
}

}  // namespace

TEST_CASE("the overview names every option that is offered, and no other") {
    const std::string text = help("");
    for (const OptionRow& row : option_table()) {
        CAPTURE(row.letters, row.keyword, row.word);
        const std::string term = "  " + manual_entry(row).term;
        CHECK((has(text, term + " ") || has(text, term + "\n")) ==
              (row.unoffered == Unoffered::no));
    }
    std::size_t start = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\n') continue;
        CAPTURE(text.substr(start, i - start));
        CHECK(i - start <= 80);
        start = i + 1;
    }
}

TEST_CASE("topics are items, groups, functions and options") {
    CHECK(has(help("sphere"), "sphere { centre, radius }"));
    CHECK(has(help("Sphere"), "sphere { centre, radius }"));
    CHECK(has(help("light samplers"), "light_octree"));
    CHECK(has(help("light_samplers"), "linear_alpha"));
    CHECK(has(help("light_octree"), "threshold"));
    CHECK(has(help("vrotate"), "vrotate("));
    CHECK(has(help("+W"), "+Wn, Width=n"));
    CHECK(has(help("Width"), "+Wn, Width=n"));
    CHECK(has(help("#while"), "#while (condition)"));
    CHECK(has(help("union"), "union { objects modifiers }"));
    CHECK(has(help("camera"), "--help cameras"));
    CHECK(has(help("media"), "not available"));
    CHECK(has(help("max_trace_level"), "in global_settings"));
    CHECK(has(help("--samples"), "--samples n"));
    CHECK(has(help("compatibility"), "+UF, -UF, Field_Render=on"));
    CHECK(help("shpere") == "! there is no help on `shpere` | did you mean `sphere`?");
    CHECK(help("qqqqqq") == "! there is no help on `qqqqqq` | --help lists the options");
}

TEST_CASE("descriptions exist in all parts and forms") {
    for (const char* part : {"", "items", "functions", "options", "compatibility", "words"}) {
        for (const ManualForm form : {ManualForm::text, ManualForm::roff, ManualForm::json}) {
            CAPTURE(part);
            Diagnostics diagnostics;
            const std::string text = description(part, form, diagnostics);
            CHECK(diagnostics.all().empty());
            CHECK(text.size() > 500);
            CHECK(text.back() == '\n');
            if (form == ManualForm::json) CHECK_FALSE(nlohmann::json::parse(text).empty());
        }
    }
    Diagnostics diagnostics;
    CHECK(description("colours", ManualForm::text, diagnostics).empty());
    CHECK(diagnostics.error_count() == 1);
}

TEST_CASE("name and version") {
    CHECK(version_text().starts_with("Candelabra "));
    CHECK(version_text().back() == '\n');
}
