// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/diagnostics_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candelabra {

using Json = nlohmann::json;

TEST_CASE("a diagnostic's facts as JSON", "[console]") {
    SourceStore sources;
    const SourceId id = sources.add("scène.pov", "sphere {\n  \"ä\", 1\n}\n");
    Diagnostic problem = error(Fault::wrong_type, {id, 11, 15}, "a string");
    problem.with_help("a vector")
        .with_note("so it is")
        .with_label("this")
        .pointing({id, 0, 6}, "in this");
    problem.frames.push_back({Frame::macro, "M", {id, 0, 6}});
    const std::string text = to_json(problem, sources);
    CHECK(text.find('\n') == text.size() - 1);
    const Json json = Json::parse(text);
    CHECK(json["severity"] == "error");
    CHECK(json["name"] == "wrong-type");
    CHECK(json["message"] == "a string");
    CHECK(json["place"]["file"] == "scène.pov");
    CHECK(json["place"]["line"] == 2);
    CHECK(json["place"]["column"] == 3);
    CHECK(json["place"]["end_column"] == 6);
    CHECK(json["place"]["first"] == 11);
    CHECK(json["label"] == "this");
    CHECK(json["labels"][0]["text"] == "in this");
    CHECK(json["labels"][0]["place"]["line"] == 1);
    CHECK(json["notes"] == Json::array({"so it is"}));
    CHECK(json["help"] == "a vector");
    CHECK(json["frames"][0]["kind"] == "macro");
    CHECK(json["frames"][0]["called_at"]["column"] == 1);
}

TEST_CASE("what has no place and no meaning in UTF-8 can be said, too", "[console]") {
    const Json json =
        Json::parse(to_json(warning(Fault::option, {}, "\xFF is ignored"), SourceStore()));
    CHECK(json["place"].is_null());
    CHECK(json["message"].get<std::string>().ends_with(" is ignored"));
    CHECK(Json::parse(debug_to_json("a\n"))["message"] == "a\n");
}

}  // namespace candelabra
