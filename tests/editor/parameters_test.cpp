// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/parameters.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

constexpr const char* content = "ab\ncd";

/// Returns the problem with reading the JSON in this way.
template <class Read>
std::string problem_of(const Json& json, const Read& read) {
    Parameters parameters(json);
    read(parameters);
    return parameters.problem();
}

std::string as_place(const Json& position) {
    return problem_of(Json{{"position", position}},
                      [](Parameters& p) { p.place(content, {"position"}); });
}

std::string as_change(const Json& changes) {
    return problem_of(Json{{"contentChanges", changes}},
                      [](Parameters& p) { p.changed_text(content); });
}

}  // namespace

TEST_CASE("parameters are read as what they must be") {
    const Json json = {{"textDocument", {{"uri", "file:///a%20b"}}},
                       {"position", {{"line", 1}, {"character", 2147483647}}},
                       {"range",
                        {{"start", {{"line", 0}, {"character", 1}}},
                         {"end", {{"line", 2147483647}, {"character", 0}}}}},
                       {"color", {{"red", 1}, {"green", 0.5}}},
                       {"contentChanges", {{{"text", "a"}}, {{"text", "b"}}}}};
    Parameters parameters(json);
    CHECK(parameters.document() == "/a b");
    CHECK(parameters.place(content, {"position"}) == 5);
    CHECK(parameters.range(content, "range").first == 1);
    CHECK(parameters.range(content, "range").last == 5);
    CHECK(parameters.channel({"color", "red"}) == 1);
    CHECK(parameters.channel({"color", "green"}) == 0.5);
    CHECK(parameters.changed_text("old") == "b");
    CHECK(parameters.problem().empty());
}

TEST_CASE("the first parameter that is wrong is named") {
    const Json none;
    Parameters parameters(none);
    CHECK(parameters.text({"a", "b"}).empty());
    CHECK(parameters.document().empty());
    CHECK(parameters.problem() == "`params.a.b` must be a string");
    for (const Json& bad :
         {Json(7), Json(), Json::array(), Json("x"), Json{{"textDocument", 7}},
          Json{{"textDocument", {{"uri", Json::array()}}}}, Json{{"textDocument", {{"uri", ""}}}},
          Json{{"textDocument", {{"uri", "file:///a%00b"}}}}})
        CHECK_FALSE(problem_of(bad, [](Parameters& p) { p.document(); }).empty());
}

TEST_CASE("places and colours have bounds") {
    CHECK(as_place({{"line", 99}, {"character", 99}}).empty());
    for (const Json& bad :
         {Json(), Json(7), Json::array(), Json{{"line", 0}}, Json{{"line", -1}, {"character", 0}},
          Json{{"line", 0}, {"character", -1}}, Json{{"line", 0.5}, {"character", 0}},
          Json{{"line", "0"}, {"character", 0}}, Json{{"line", 2147483648}, {"character", 0}},
          Json{{"line", 0}, {"character", 18446744073709551615u}}}) {
        CAPTURE(bad.dump());
        CHECK(as_place(bad) ==
              "`params.position` must be a position: `line` and `character`, "
              "integers from 0 to 2147483647");
    }
    const Json first = {{"line", 0}, {"character", 0}}, second = {{"line", 1}, {"character", 0}};
    const auto as_range = [&](const Json& start, const Json& end) {
        return problem_of(Json{{"range", {{"start", start}, {"end", end}}}},
                          [](Parameters& p) { p.range(content, "range"); });
    };
    CHECK(as_range(first, second).empty());
    CHECK_FALSE(as_range(second, first).empty());
    CHECK_FALSE(as_range(first, 7).empty());
    for (const Json& bad : {Json(-0.1), Json(1.1), Json(1e308), Json("1"), Json()})
        CHECK_FALSE(
            problem_of(Json{{"red", bad}}, [](Parameters& p) { p.channel({"red"}); }).empty());
}

namespace {

Json at(int line, int character) { return {{"line", line}, {"character", character}}; }

Json part_change(const Json& start, const Json& end, const std::string& text) {
    return {{"range", {{"start", start}, {"end", end}}}, {"text", text}};
}

/// Returns "ab\ncd" after the changes.
std::string changed(const Json& changes) {
    const Json json = {{"contentChanges", changes}};
    Parameters parameters(json);
    std::string text = parameters.changed_text(content);
    return parameters.problem().empty() ? text : "refused";
}

}  // namespace

TEST_CASE("changes are made one after the other") {
    CHECK(changed(Json::array({part_change(at(0, 1), at(0, 1), "x")})) == "axb\ncd");
    CHECK(changed(Json::array({part_change(at(0, 1), at(1, 1), "")})) == "ad");
    CHECK(changed(Json::array({part_change(at(0, 0), at(0, 0), "1\n"),
                               part_change(at(1, 1), at(1, 2), "2")})) == "1\na2\ncd");
    CHECK(changed({{{"text", "z"}}, part_change(at(0, 1), at(9, 9), "!")}) == "z!");
    // Positions beyond the end of a line, or of the text, are at that end.
    CHECK(changed(Json::array({part_change(at(0, 99), at(0, 2147483647), "!")})) == "ab!\ncd");
    CHECK(changed(Json::array({part_change(at(99, 0), at(99, 99), "!")})) == "ab\ncd!");
    // A position between the halves of a surrogate pair is after it.
    CHECK(changed({{{"text", "\U0001F4A1x"}}, part_change(at(0, 1), at(0, 2), "-")}) ==
          "\U0001F4A1-x");
}

TEST_CASE("changes make no document of more than 64 MB") {
    const std::string half(Parameters::longest_document / 2, 'x');
    const Json whole = {{"text", half}};
    const Json more = part_change(at(0, 0), at(0, 0), half);
    CHECK(changed({whole, more}).size() == Parameters::longest_document);
    CHECK(changed({whole, more, part_change(at(0, 0), at(0, 0), "x")}) == "refused");
}

TEST_CASE("changes are whole texts or parts of them") {
    CHECK(as_change({{{"text", ""}}}).empty());
    for (const Json& bad :
         {Json(), Json(7), Json::array(), Json::object(), Json::array({7}), Json::array({nullptr}),
          Json::array({{{"text", 7}}}), Json::array({{{"text", "a"}, {"range", nullptr}}}),
          Json::array({{{"text", "a"}, {"range", {{"start", at(1, 0)}, {"end", at(0, 2)}}}}}),
          Json::array({{{"range", {{"start", at(0, 0)}, {"end", at(0, 1)}}}}}),
          Json::array({Json::array(), {{"text", "a"}}})}) {
        CAPTURE(bad.dump());
        CHECK_FALSE(as_change(bad).empty());
    }
}

}  // namespace candelabra
