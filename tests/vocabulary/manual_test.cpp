// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/manual.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <array>

namespace candelabra {

namespace {

struct Lamp {
    Vec3 centre = Vec3(0);
    double power = 2;
    double hole = 0;
    int count = 3;
    bool open = false;
    Rgb tint = Rgb(1, 0.5, 0);
    std::optional<double> angle;
    std::string font = "plain";

    static const ItemInfo vocabulary;
};

const ItemInfo Lamp::vocabulary = described<Lamp>([] {
    using F = Field<Lamp>;
    return schema<Lamp>("lamp", "Something that shines.",
                        F{"centre", &Lamp::centre, positional, "where it is"},
                        F{"power", &Lamp::power, positional, "how bright", above(0)},
                        maybe(F{"hole", &Lamp::hole, positional, "what is missing", at_least(0)}),
                        F{"count", &Lamp::count, item, "how many", between(1, 9)},
                        F{"open", &Lamp::open, flag, "without ends"},
                        F{"tint", &Lamp::tint, item,
                          ".5 is half of it: a very long explanation, so that it does "
                          "not fit into one line of \"80\""},
                        F{"angle", &Lamp::angle, item, "how wide", Range{0, 360, true}},
                        F{"font", &Lamp::font, item, "how it is written"});
});

const ItemInfo& lamp = Lamp::vocabulary;
constexpr std::array lamps = {&Lamp::vocabulary};
constexpr std::array groups = {ItemGroup{"Lamps", "All of them.", lamps, "light"}};

}  // namespace

TEST_CASE("lines of roff are no commands", "[vocabulary]") {
    CHECK(roff_lines("a-b") == "a\\-b\n");
    CHECK(roff_lines(std::string(76, 'x') + " ...ends") == std::string(76, 'x') + "\n\\&...ends\n");
}

TEST_CASE("usage shows how an item is written") {
    CHECK(usage(lamp) ==
          "lamp { centre, power[, hole] [count n] [open] [tint v] [angle n] [font v] }");
    CHECK(usage(lamp, "light") ==
          "light { lamp centre, power[, hole] [count n] [open] [tint v] [angle n] [font v] }");
}

TEST_CASE("a field's values are told with range and default") {
    const char* expected[] = {
        "vector",
        "number above 0",
        "number from 0 on, default 0",
        "whole number from 1 to 9, default 3",
        "on or off, default off",
        "colour, default rgb <1, 0.5, 0>",
        "number above 0 to 360",
        "string, default \"plain\"",
    };
    REQUIRE(lamp.fields.size() == std::size(expected));
    for (std::size_t i = 0; i < std::size(expected); ++i) CHECK(values(lamp, i) == expected[i]);
}

TEST_CASE("plain text") {
    CHECK(manual(groups, ManualForm::text) ==
          "Lamps: All of them.\n"
          "\n"
          "light { lamp centre, power[, hole] [count n] [open] [tint v] [angle n] [font\n"
          "    v] }\n"
          "  Something that shines.\n"
          "  centre                  where it is (vector)\n"
          "  power                   how bright (number above 0)\n"
          "  hole                    what is missing (number from 0 on, default 0)\n"
          "  count n                 how many (whole number from 1 to 9, default 3)\n"
          "  open                    without ends (on or off, default off)\n"
          "  tint v                  .5 is half of it: a very long explanation, so that it\n"
          "                          does not fit into one line of \"80\" (colour, default\n"
          "                          rgb <1, 0.5, 0>)\n"
          "  angle n                 how wide (number above 0 to 360)\n"
          "  font v                  how it is written (string, default \"plain\")\n");
}

TEST_CASE("roff hides what would be commands") {
    struct Case {
        const char* text;
        const char* expected;
    };
    const Case cases[] = {
        {"plain", "plain"},       {".5 of it", "\\&.5 of it"},
        {"a-b", "a\\-b"},         {"C:\\x", "C:\\ex"},
        {"'it'", "\\(aqit\\(aq"}, {"\"q\"", "\\(dqq\\(dq"},
        {"`w`", "\\(gaw\\(ga"},   {"a\nb", "a b"},
        {"x^2~", "x\\(ha2\\(ti"},
    };
    for (const Case& each : cases) CHECK(roff(each.text) == each.expected);

    const std::string page = manual(groups, ManualForm::roff);
    CHECK(page.starts_with(".SS Lamps\nAll of them.\n.PP\n.B light { lamp centre, power[, hole]"));
    CHECK(page.find(".TP\n.B tint v\n\\&.5 is half of it") != std::string::npos);
    std::size_t line = 0;
    for (std::size_t i = 0; i < page.size(); ++i) {
        if (page[i] != '\n') continue;
        CAPTURE(page.substr(line, i - line));
        const bool command = page[line] == '.';
        CHECK((command || i - line <= 80));
        CHECK((!command || (page[line + 1] >= 'A' && page[line + 1] <= 'Z') ||
               page.substr(line, 3) == ".br"));
        line = i + 1;
    }
}

TEST_CASE("JSON for editors holds every field with its type, range and default") {
    const auto json = nlohmann::json::parse(manual(groups, ManualForm::json));
    REQUIRE(json.size() == 1);
    const auto& item = json[0]["items"][0];
    CHECK(item["name"] == "lamp");
    CHECK(item["usage"] == usage(lamp, "light"));
    const auto& fields = item["fields"];
    REQUIRE(fields.size() == 8);
    CHECK(fields[1]["above"] == 0);
    CHECK(fields[1]["optional"] == false);
    CHECK(fields[2]["optional"] == true);
    CHECK(fields[3]["minimum"] == 1);
    CHECK(fields[3]["maximum"] == 9);
    CHECK(fields[3]["default"] == 3);
    CHECK(fields[4]["place"] == "flag");
    CHECK(fields[5]["type"] == "colour");
    CHECK(fields[5]["default"] == nlohmann::json({1.0, 0.5, 0.0}));
    CHECK(fields[6]["default"].is_null());
    CHECK(fields[7]["default"] == "plain");
}

TEST_CASE("lists have the same three forms") {
    const std::array list = {ManualEntry{"+Wn", "width"},
                             ManualEntry{"--a-very-long-option NAME", "-x"}};
    CHECK(manual(list, ManualForm::text) ==
          "  +Wn                     width\n"
          "  --a-very-long-option NAME\n"
          "                          -x\n");
    CHECK(manual(list, ManualForm::roff) ==
          ".TP\n.B +Wn\nwidth\n.TP\n.B \\-\\-a\\-very\\-long\\-option NAME\n\\-x\n");
    CHECK(nlohmann::json::parse(manual(list, ManualForm::json))[1]["term"] ==
          "--a-very-long-option NAME");
}

TEST_CASE("text is broken between words") {
    CHECK(wrapped("one two three", 2, 9) == "one two\n  three");
    CHECK(wrapped("unbreakable", 2, 5) == "unbreakable");
    CHECK(wrapped("", 2, 5).empty());
}

}  // namespace candelabra
