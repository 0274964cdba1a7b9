// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_store.h"

#include "options/option_table.h"
#include "options/read_words.h"

#include <catch2/catch.hpp>

#include <limits>

namespace candelabra {

TEST_CASE("a number is all of a text or nothing") {
    struct Case {
        const char* text;
        std::optional<double> expected;
    };
    const Case cases[] = {
        {"1", 1},    {"-1.5", -1.5}, {"+2", 2},   {".5", 0.5},   {"5.", 5},  {"1e3", 1000},
        {"", {}},    {"+", {}},      {"+-1", {}}, {"1 ", {}},    {" 1", {}}, {"0x10", {}},
        {"nan", {}}, {"inf", {}},    {"1,5", {}}, {"1e999", {}},
    };
    for (const Case& each : cases) {
        CAPTURE(each.text);
        CHECK(number(each.text) == each.expected);
    }
}

TEST_CASE("truth has several words") {
    for (const char* yes : {"on", "ON", "true", "Yes", "1"}) CHECK(truth(yes) == true);
    for (const char* no : {"off", "FALSE", "no", "0"}) CHECK(truth(no) == false);
    for (const char* neither : {"", "maybe", "2", "onn"}) CHECK_FALSE(truth(neither));
}

TEST_CASE("letters are compared without their case, other bytes as they are") {
    CHECK(same_letters("Width", "wIDTH"));
    CHECK(same_letters("", ""));
    CHECK_FALSE(same_letters("W", "WT"));
    CHECK_FALSE(same_letters("[", "{"));
}

TEST_CASE("a setting outside its range is refused and not stored") {
    Options options;
    Diagnostics diagnostics;
    store::field("seed", options, {"--seed", true, "12"}, diagnostics);
    CHECK(options.render.seed == 12);
    for (const char* wrong : {"-1", "1.5", "many", "1e12", ""})
        store::field("seed", options, {"--seed", true, wrong}, diagnostics);
    CHECK(options.render.seed == 12);
    CHECK(diagnostics.error_count() == 5);
}

TEST_CASE("what an INI file says behind the point of a whole number is told of") {
    Options options;
    Diagnostics diagnostics;
    store::field("width", options, {"Width=160.7", true, "160.7", "a.ini:3"}, diagnostics);
    CHECK(options.render.width == 160);
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all()[0].severity == Severity::warning);
    CHECK(diagnostics.all()[0].message == "a.ini:3: `Width=160.7` counts as 160");
    store::field("height", options, {"Height=120.0", true, "120.0", "a.ini:4"}, diagnostics);
    CHECK(options.render.height == 120);
    CHECK(diagnostics.all().size() == 1);
    store::field("width", options, {"+W160.7", true, "160.7"}, diagnostics);
    CHECK(diagnostics.error_count() == 1);
}

TEST_CASE("settings of whole numbers have both bounds", "[app]") {
    for (const ItemInfo* item : {&RenderSettings::vocabulary, &AnimationSettings::vocabulary})
        for (const FieldInfo& field : item->fields) {
            if (field.type != FieldType::integer) continue;
            INFO(field.name);
            CHECK(field.range.low >= std::numeric_limits<int>::min());
            CHECK(field.range.high <= std::numeric_limits<int>::max());
        }
    // Numbers in a file are truncated before they are checked.
    for (const OptionRow& row : option_table()) {
        if (row.field.empty() || row.keyword.empty()) continue;
        if (find_setting(row.field).info().type != FieldType::integer) continue;
        for (const char* value : {"1e300", "-1e300", "2147483648", "-2147483649", "1e10", "inf"}) {
            const std::string option = std::string(row.keyword) + "=" + value;
            INFO(option);
            Diagnostics on_line, in_file;
            read_options(std::vector<std::string_view>{option}, on_line);
            CHECK(on_line.failed());
            const Reader file = [&](const std::string&) { return std::optional(option); };
            read_options(std::vector<std::string_view>{"a.ini"}, in_file, file);
            CHECK(in_file.failed());
        }
    }
    read({"+STP2147483648"}, false);
    read({"Frame_Step=1e300"}, false);
    CHECK(read({"+STP1000000000"}).animation.frame_step == 1'000'000'000);
}

}  // namespace candelabra
