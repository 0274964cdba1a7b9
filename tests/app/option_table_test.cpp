// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_table.h"

#include <catch2/catch.hpp>

#include <set>

TEST_CASE("no switch, keyword or word stands in the table twice, and every row leads somewhere") {
    std::set<std::string_view> letters, keywords, words;
    for (const OptionRow& row : option_table()) {
        CAPTURE(row.letters, row.keyword, row.word);
        CHECK((row.letters.empty() || letters.insert(row.letters).second));
        CHECK((row.keyword.empty() || keywords.insert(row.keyword).second));
        CHECK((row.word.empty() || words.insert(row.word).second));
        CHECK_FALSE((row.letters.empty() && row.keyword.empty() && row.word.empty()));
        CHECK((row.takes != Takes::value || !row.parameter.empty()));
        if (row.unoffered != Unoffered::no) continue;
        CHECK((row.store != nullptr) != (find_setting(row.field).item != nullptr));
        CHECK_FALSE(manual_entry(row).help.empty());
    }
}

TEST_CASE("every setting of the run but the sampler's parameters has an option") {
    for (const FieldInfo& field : RenderSettings::vocabulary.fields) {
        CAPTURE(field.name);
        bool found = field.name == "antialias";  // +A does more than store it
        for (const OptionRow& row : option_table()) found = found || row.field == field.name;
        CHECK(found);
    }
}

TEST_CASE("an option is shown in all of its forms") {
    const auto shown = [](std::string_view name) {
        for (const OptionRow& row : option_table())
            if (row.letters == name || row.word == name) return manual_entry(row);
        return ManualEntry();
    };
    CHECK(shown("W").term == "+Wn, Width=n");
    CHECK(shown("W").help ==
          "width of the picture in pixels (whole number from 1 to 65535, default 640)");
    CHECK(shown("A").term == "+At, -A, Antialias=on");
    CHECK(shown("WT").term == "+WTn, Work_Threads=n, --threads n");
    CHECK(shown("V").term == "+V, -V, Verbose=on");
    CHECK(shown("check").term == "--check[=syntax]");
    CHECK(shown("help").term == "--help [topic]");
    CHECK(shown("version").term == "--version");
}

TEST_CASE("an unoffered option is taken, warned of, or refused") {
    const auto outcome = [](Unoffered unoffered, bool on) {
        OptionRow row{"Z", "", "", "", Takes::sign, "because"};
        row.unoffered = unoffered;
        Options options;
        Diagnostics diagnostics;
        apply(row, options, {"+Z", on, {}}, diagnostics);
        return diagnostics.all().empty() ? "" : diagnostics.all()[0].message;
    };
    CHECK(outcome(Unoffered::accepted, true).empty());
    CHECK(outcome(Unoffered::ignored, true) == "`+Z` is ignored: because");
    CHECK(outcome(Unoffered::refused, true) == "`+Z`: is not offered: because");
    CHECK(outcome(Unoffered::refused, false).empty());
}
