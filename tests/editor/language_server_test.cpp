// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/language_server.h"

#include "support/folder.h"

namespace {

/// An editor with one file.
struct Client {
    Folder folder;
    std::vector<Json> answers;
    LanguageServer server{
        CANDELABRA_SOURCE_DIR "/stdlib", folder / "scratch",
        [this](const std::string& text) { answers.push_back(Json::parse(text)); }};
    std::string uri = uri_of(folder / "a.pov");

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

constexpr const char* scene =
    "#declare Size = 1;\n"
    "camera { location -5*z look_at 0 }\n"
    "sphere { 0, Size pigment { rgb <1, 0, 0> } finish { emission 1 } }\n";

}  // namespace

TEST_CASE("an editor's requests are answered") {
    Client client;
    CHECK(client.ask("initialize")["capabilities"]["hoverProvider"] == true);
    client.open(scene);
    CHECK(client.ask_at("hover", 2, 13)["range"]["start"]["character"] == 12);
    CHECK(client.ask_at("completion", 2, 42).size() > 100);
    CHECK(client.ask_at("definition", 2, 13)[0]["range"]["start"]["line"] == 0);
    CHECK(client.ask_at("references", 2, 13).size() == 2);
    CHECK(client.ask_at("rename", 2, 13, {{"newName", "R"}})["changes"][client.uri].size() == 2);
    CHECK(client.ask_at("rename", 2, 13, {{"newName", "box"}})["message"] ==
          "`box` is a word of the language");
    CHECK(client.ask_at("documentSymbol", 0, 0)[0]["name"] == "Size");
    CHECK(client.ask_at("documentColor", 0, 0)[0]["color"]["red"].get<double>() == Approx(1));
    const Json place = {{"start", {{"line", 2}, {"character", 27}}},
                        {"end", {{"line", 2}, {"character", 40}}}};
    CHECK(client.ask_at("colorPresentation", 0, 0,
                        {{"color", {{"red", 0}, {"green", 1}, {"blue", 0}}},
                         {"range", place}})[0]["label"] == "rgb <0, 1, 0>");
    CHECK(client.ask_at("formatting", 0, 0) == Json::array());
}

TEST_CASE("mistakes are published when the editor is silent, and gone when they are mended") {
    Client client;
    client.open("sphere { 0, Size }");
    REQUIRE(client.server.behind());
    client.server.catch_up();
    CHECK_FALSE(client.server.behind());
    REQUIRE(client.answers.size() == 1);
    CHECK(client.answers[0]["method"] == "textDocument/publishDiagnostics");
    CHECK(client.answers[0]["params"]["diagnostics"][0]["severity"] == 1);
    client.tell("textDocument/didChange",
                {{"textDocument", {{"uri", client.uri}}}, {"contentChanges", {{{"text", scene}}}}});
    client.answers.clear();
    client.server.catch_up();
    CHECK(client.answers.at(0)["params"]["diagnostics"].empty());
}

TEST_CASE("odd messages do no harm") {
    Client client;
    for (const char* message :
         {"", "7", "[]", "{", "{}", "{\"method\": 7}", "{\"method\": \"textDocument/hover\"}",
          "{\"method\": \"textDocument/didChange\", \"params\": []}",
          "{\"method\": \"textDocument/didOpen\", \"params\": \"a\"}"})
        client.server.receive(message);
    client.server.catch_up();
    CHECK(client.ask("textDocument/hover") == nullptr);
    CHECK(client.ask("nothing/such")["code"] == -32601);
    CHECK_FALSE(client.server.ended());
}

TEST_CASE("the editor says goodbye in two steps") {
    Client client;
    client.tell("exit", nullptr);
    CHECK(client.server.ended());
    CHECK_FALSE(client.server.ended_well());
    Client other;
    CHECK(other.ask("shutdown") == nullptr);
    other.tell("exit", nullptr);
    CHECK(other.server.ended_well());
}
