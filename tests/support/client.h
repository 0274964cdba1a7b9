// SPDX-License-Identifier: GPL-3.0-or-later
// An editor that follows a script: it sends messages of the Language Server Protocol and keeps the
// answers.
#pragma once

#include "editor/language_server.h"
#include "support/folder.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace candelabra {

/// An editor with one file.
struct Client {
    Folder folder;
    std::vector<Json> answers;
    LanguageServer server{
        CANDELABRA_SOURCE_DIR "/stdlib", folder / "scratch",
        [this](const std::string& text) { answers.push_back(Json::parse(text)); }};
    std::string uri = uri_of(folder / "a.pov");

    explicit Client(bool greets = true) {
        if (greets) ask("initialize");
        answers.clear();
    }
    void tell(const std::string& method, const Json& parameters) {
        server.receive(Json{{"method", method}, {"params", parameters}}.dump());
    }
    Json ask(const std::string& method, Json parameters = Json::object()) {
        answers.clear();
        server.receive(Json{{"id", 7}, {"method", method}, {"params", parameters}}.dump());
        REQUIRE(answers.size() == 1);
        CHECK(answers[0]["id"] == 7);
        return answers[0].contains("error") ? answers[0]["error"] : answers[0]["result"];
    }
    Json ask_at(const std::string& method, int line, int character, Json more = Json::object()) {
        more["textDocument"]["uri"] = uri;
        more["position"] = {{"line", line}, {"character", character}};
        return ask("textDocument/" + method, more);
    }
    void open(const std::string& text) {
        tell("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"text", text}}}});
    }
};

inline constexpr const char* client_scene =
    "#declare Size = 1;\n"
    "camera { location -5*z look_at 0 }\n"
    "sphere { 0, Size pigment { rgb <1, 0, 0> } finish { emission 1 } }\n";

}  // namespace candelabra
