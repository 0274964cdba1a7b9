// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/data_reader.h"

#include "text/message.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string written(const Value& value) {
    if (value.broken()) return "broken";
    if (value.text()) return "'" + *value.text() + "'";
    std::string text;
    const Numbers& numbers = *value.numbers();
    for (int i = 0; i < numbers.count; ++i)
        text += message(i > 0 ? "," : "", numbers.at[static_cast<std::size_t>(i)]);
    return numbers.is_scalar() ? text : "<" + text + ">";
}

/// All values, `|` where the reader was at its end, `...` where it was not, and the first message.
std::string all_values(const std::string& data) {
    SourceStore sources;
    Names names;
    Diagnostics diagnostics;
    DataReader reader(sources.add("data.txt", data), sources, names, diagnostics);
    std::string result;
    for (int i = 0; i < 20; ++i) {
        const auto value = reader.next();
        if (!value) return result + "none" + (reader.at_end() ? "|" : "...");
        result += written(*value) + " ";
        if (value->broken()) return result + diagnostics.all().at(0).message;
        if (reader.at_end()) return result + "|";
    }
    return result;
}

}  // namespace

TEST_CASE("a data file gives its values in order", "[files]") {
    struct Case {
        const char* data;
        const char* values;
    };
    const Case cases[] = {
        {"1,2,3", "1 2 3 |"},
        {"1,\n2\n", "1 2 |"},
        {"1, // c\n2 /* x */ ,+3,-.5e1", "1 2 3 -5 |"},
        {"\"abc\",\"a\\nb\"", "'abc' 'a\nb' |"},
        {"<1,-2>,<1,2,3>,<1,2,3,4>,<1,2,3,4,5>", "<1,-2> <1,2,3> <1,2,3,4> <1,2,3,4,5> |"},
        {"< 1 /* one */, +2 >, <1 2 3>", "<1,2> <1,2,3> |"},
        {"1 2 3\n4 5", "1 2 3 4 5 |"},
        {"1+2,3", "1 2 3 |"},
        {"1,2,\n3,\n", "1 2 3 none|"},
        {"", "none|"},
        {"// nothing\n", "none|"},
    };
    for (const Case& c : cases) {
        INFO(c.data);
        CHECK(all_values(c.data) == c.values);
    }
}

TEST_CASE("what is no value is reported where it stands", "[files]") {
    CHECK(all_values("1,abc") == "1 broken this is no value that #read can take");
    CHECK(all_values(",1") == "broken this is no value that #read can take");
    CHECK(all_values("1,-\"a\"") == "1 broken this is no value that #read can take");
    CHECK(all_values("<1>") == "broken a vector in a data file has 2 to 5 numbers");
    CHECK(all_values("<1,2,3,4,5,6>") == "broken a vector in a data file has 2 to 5 numbers");
    CHECK(all_values("<1,2") == "broken this is no value that #read can take");
    CHECK(all_values("sqrt(4)") == "broken this is no value that #read can take");
}

}  // namespace candelabra
