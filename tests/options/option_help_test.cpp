// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_help.h"

#include "support/shell.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace candelabra {

TEST_CASE("an option is shown in all of its forms") {
    const auto shown = [](std::string_view name) {
        for (const OptionRow& row : option_table())
            if (row.letters == name || row.word == name) return manual_entry(row);
        return ManualEntry();
    };
    CHECK(shown("W").term == "+Wn, Width=n, --width n");
    CHECK(shown("W").help ==
          "width of the picture in pixels (whole number from 1 to 65535, default 640)");
    CHECK(shown("A").term == "+At, -A, Antialias=on, --antialias");
    CHECK(shown("WT").term == "+WTn, Work_Threads=n, --threads n");
    CHECK(shown("V").term == "+V, -V, Verbose=on, --verbose");
    CHECK(shown("check").term == "--check[=syntax]");
    CHECK(shown("help").term == "--help [topic]");
    CHECK(shown("version").term == "--version");
}

TEST_CASE("the short help fits on a screen and leads to every group") {
    const std::string text = short_help();
    CHECK(std::ranges::count(text, '\n') <= 40);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        CAPTURE(text.substr(at, end - at));
        CHECK(end - at <= 80);
        at = end + 1;
    }
    for (const OptionGroupInfo& group : option_groups())
        CHECK(has(text, group.name) == (group.group != OptionGroup::povray));
    CHECK(has(text, "--help all"));
    for (const OptionRow& row : option_table())
        if (row.basic) CHECK(has(text, "--" + long_name(row)));
    CHECK(has(text, "+W, --width n"));
}

TEST_CASE("the long help has each option that is offered, once, in its group") {
    const std::string text = long_help();
    std::size_t before = 0;
    for (const OptionGroupInfo& group : option_groups()) {
        if (group.group == OptionGroup::povray) continue;
        const std::size_t at = text.find("Options of the group " + std::string(group.name));
        REQUIRE(at != text.npos);
        CHECK(at > before);
        before = at;
        const std::string own = option_help(std::string(group.name) + " options");
        CHECK(has(text, own));
        for (const OptionRow& row : option_table()) {
            if (row.unoffered != Unoffered::no) continue;
            CAPTURE(group.name, long_name(row));
            CHECK(has(own, "  " + manual_entry(row).term + "\n") +
                      has(own, "  " + manual_entry(row).term + "  ") ==
                  (row.group == group.group));
        }
    }
    CHECK(option_help("film_options") == option_help("film options"));
}

TEST_CASE("each row of the help can be read by itself") {
    std::map<std::string, std::string> known;
    for (const OptionRow& row : option_table()) {
        if (row.unoffered != Unoffered::no) continue;
        const ManualEntry entry = manual_entry(row);
        CAPTURE(entry.term, entry.help);
        CHECK_FALSE(has(entry.help, "the same"));
        CHECK_FALSE(has(entry.help, "those rays"));
        CHECK_FALSE(has(entry.help, "two of them"));
        CHECK_FALSE(entry.help.starts_with("its "));
        CHECK(entry.help.size() > 15);
    }
}

TEST_CASE("programs get type, range, default and effect of each option") {
    const auto all = nlohmann::json::parse(options_as_json(true, "option"));
    const auto option = [&](std::string_view name) {
        for (const auto& each : all)
            if (each.value("long", "") == name) return each;
        return nlohmann::json();
    };
    CHECK(option("width")["type"] == "integer");
    CHECK(option("width")["low"] == 1);
    CHECK(option("width")["default"] == 640);
    CHECK(option("width")["switch"] == "W");
    CHECK(option("width")["changes"] == "picture");
    CHECK(option("width")["group"] == "picture");
    CHECK(option("antialias")["default"] == true);
    CHECK(option("frame-rate")["above"] == 0);
    CHECK(option("frame-rate")["default"] == 25);
    CHECK(option("progress")["values"].size() == 7);
    CHECK(option("progress")["default"] == "auto");
    CHECK(option("limit-text")["default"] == 64);
    CHECK(option("threads")["changes"] == "nothing");
    CHECK(option("bits-per-color")["changes"] == "file");
    for (const auto& each : all) {
        INFO(each.dump());
        CHECK_FALSE(each.value("type", "").empty());
        CHECK_FALSE(each.value("group", "").empty());
        CHECK_FALSE(each.value("changes", "").empty());
    }
    for (const auto& each : nlohmann::json::parse(options_as_json(false, "term")))
        CHECK(each["group"] == "compatibility");
}

}  // namespace candelabra
