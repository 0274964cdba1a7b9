// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/json_reader.h"

#include "interpret/array_data.h"
#include "text/message.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string shown(const Value& value) {
    if (value.absent()) return "-";
    if (value.text()) return "'" + *value.text() + "'";
    if (value.numbers()) return message(value.numbers()->at[0]);
    const ArrayData& array = *value.array();
    std::string text;
    for (const int size : array.sizes()) text += message("[", size, "]");
    if (array.names()) {
        text += "(";
        for (const std::string& name : array.names()->all())
            text += (text.ends_with('(') ? "" : " ") + name;
        text += ")";
    }
    for (std::size_t i = 0; i < array.size(); ++i)
        text += (i == 0 ? "{" : " ") + shown(array.at(i));
    return text + "}";
}

std::string json(std::string_view text, std::size_t most = 100) {
    JsonProblem problem;
    const auto value = read_json(text, most, problem);
    if (value) return shown(*value);
    return message(problem.placed ? message(problem.at, ": ") : "", problem.message);
}

}  // namespace

TEST_CASE("values of JSON", "[json]") {
    struct Case {
        const char* text;
        const char* value;
    };
    const Case cases[] = {
        {"1.5", "1.5"},
        {"\"a\\u00e9\"", "'a\xC3\xA9'"},
        {"[1, -2, 3e2]", "[3]{1 -2 300}"},
        {"[true, false, null]", "[3]{1 0 -}"},
        {"[1, \"a\"]", "[2]{1 'a'}"},
        {"[[1, 2], [3, 4]]", "[2][2]{1 2 3 4}"},
        {"[[1, 2], [3]]", "[2]{[2]{1 2} [1]{3}}"},
        {"[[[1], [2]], [[3], [4]]]", "[2][2][1]{1 2 3 4}"},
        {"{\"x\": 1, \"y\": [2, 3]}", "[2](x y){1 [2]{2 3}}"},
        {"[{\"x\": 1, \"y\": \"a\"}, {\"x\": 2, \"y\": \"b\"}]", "[2][2](x y){1 'a' 2 'b'}"},
        {"[{\"x\": 1}, {\"y\": 2}]", "[2]{[1](x){1} [1](y){2}}"},
        {"[]", "-"},
        {"{\"a\": {}}", "[1](a){-}"},
        {"// here\n[1 /* one */]", "[1]{1}"},
        {"[[[[[[1]]]]]]", "[1]{[1][1][1][1][1]{1}}"},
    };
    for (const Case& c : cases) {
        INFO(c.text);
        CHECK(json(c.text) == c.value);
    }
}

TEST_CASE("what is no JSON is told of at its place", "[json]") {
    CHECK(json("[1, 2") == "5: is no JSON from here on");
    CHECK(json("[1 2]") == "3: is no JSON from here on");
    CHECK(json("") == "0: is no JSON from here on");
    CHECK(json("[1] 2") == "4: is no JSON from here on");
    CHECK(json("[1e999]").ends_with("is no JSON from here on"));
    CHECK(json("\"\xFF\"").ends_with("is no JSON from here on"));
    CHECK(json("[1, 2, 3]", 2) == "has more than 2 values, which is the limit");
    const std::string deep(max_json_depth + 1, '[');
    CHECK(json(deep).ends_with("inside each other, which is the limit"));
    CHECK(json(std::string(1'000'000, '[')).ends_with("inside each other, which is the limit"));
}

}  // namespace candelabra
