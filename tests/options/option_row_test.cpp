// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_row.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("groups stand in the order of their numbers") {
    const auto groups = option_groups();
    for (std::size_t i = 0; i < groups.size(); ++i)
        CHECK(static_cast<std::size_t>(groups[i].group) == i);
}

TEST_CASE("a long name is the word, or the keyword with hyphens") {
    const auto named = [](std::string_view keyword, std::string_view word) {
        OptionRow row = {};
        row.letters = "Z";
        row.keyword = keyword;
        row.word = word;
        return long_name(row);
    };
    CHECK(named("Start_Row", "") == "start-row");
    CHECK(named("Start_Row", "first") == "first");
    CHECK(named("", "").empty());
}

TEST_CASE("an unoffered option is taken, warned of, or refused") {
    const auto outcome = [](Unoffered unoffered, bool on) {
        OptionRow row = {};
        row.letters = "Z";
        row.takes = Takes::sign;
        row.help = "because";
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

}  // namespace candelabra
