// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/sheet.h"

#include "options/declared_values.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The values of all pictures as text: `Seed=1 Seed=2`.
std::string all_values(const Sheet& sheet) {
    std::string text;
    for (int i = 0; i < sheet.pictures(); ++i)
        for (const auto& [name, value] : sheet.values_in(i))
            text += (text.empty() ? "" : " ") + name + "=" + text_of(value);
    return text;
}

}  // namespace

TEST_CASE("a sheet has a picture for each value", "[options]") {
    const std::pair<std::string, std::string> rows[] = {
        {"2x2 Seed=1..4", "Seed=1 Seed=2 Seed=3 Seed=4"},
        {"2x2 Seed=4..1", "Seed=4 Seed=3 Seed=2 Seed=1"},
        {"2x1 Seed=3..3", "Seed=3 Seed=3"},
        {"1x1 Size=0.5..2", "Size=0.5"},
        {"3x1 Size=0..1", "Size=0 Size=0.5 Size=1"},
        {"3x1 Size=0..100", "Size=0 Size=50 Size=100"},
        {"3x2 A=1,5,-2.5", "A=1 A=5 A=-2.5"},
        {"2x2 A=1,2 B=3..4", "A=1 B=3 A=2 B=3 A=1 B=4 A=2 B=4"},
        {"3x1 A=1,2 B=7", "A=1 B=7 A=2 B=7"},
        {"2x1 clock=0..0.5", "clock=0 clock=0.5"},
    };
    for (const auto& [text, expected] : rows) {
        CAPTURE(text);
        std::string problem;
        const auto sheet = sheet_of(text, problem);
        REQUIRE(sheet);
        CHECK(problem.empty());
        CHECK(all_values(*sheet) == expected);
    }
}

TEST_CASE("pictures of a sheet follow each other along rows, or lie by two values", "[options]") {
    std::string problem;
    const auto one = sheet_of("3x2 A=1,2,3,4,5", problem),
               two = sheet_of("3x2 A=1,2 B=1..2", problem);
    REQUIRE((one && two));
    CHECK(one->column_of(4) == 1);
    CHECK(one->row_of(4) == 1);
    CHECK(two->column_of(2) == 0);
    CHECK(two->row_of(2) == 1);
}

TEST_CASE("other sheets are told from these", "[options]") {
    const std::pair<std::string, std::string> rows[] = {
        {"", "columns and rows"},
        {"4 Seed=1..2", "columns and rows"},
        {"0x3 Seed=1..2", "columns and rows"},
        {"4x101 Seed=1..2", "from 1 to 100"},
        {"1.5x2 Seed=1..2", "whole numbers"},
        {"4x3", "needs a name"},
        {"4x3 Seed", "needs a name and values"},
        {"4x3 sphere=1..2", "word of the language"},
        {"4x3 Seed=", "needs a range"},
        {"4x3 Seed=1..", "needs a range"},
        {"4x3 Seed=1,,2", "needs a range"},
        {"4x3 Seed=nan..2", "needs a range"},
        {"4x3 Seed=-1e308..1e308", "needs a range"},
        {"2x1 Seed=1,2,3", "3 values, and there are 2 places"},
        {"2x1 A=1..2 B=1,2", "2 values, and there are 1 places"},
        {"2x2 A=1..2 A=1..2", "given twice"},
        {"2x2 A=1 B=2 C=3", "in one name or in two"},
    };
    for (const auto& [text, expected] : rows) {
        CAPTURE(text);
        std::string problem;
        CHECK_FALSE(sheet_of(text, problem));
        CHECK_THAT(problem, Catch::Contains(expected));
    }
}

TEST_CASE("options of a picture have its values", "[options]") {
    const Options options = with_values({}, {{"clock", 0.5}, {"Seed", 3.0}});
    CHECK(options.facts.clock == 0.5);
    CHECK(options.facts.clock_given);
    REQUIRE(options.declares.size() == 1);
    CHECK(options.declares[0].first == "Seed");
}

}  // namespace candelabra
