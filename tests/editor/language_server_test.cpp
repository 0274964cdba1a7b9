// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/language_server.h"

#include "support/client.h"

#include <array>
#include <chrono>

#include <unistd.h>

namespace candelabra {

TEST_CASE("an editor's requests are answered") {
    Client client(false);
    CHECK(client.ask("initialize")["capabilities"]["hoverProvider"] == true);
    client.open(client_scene);
    CHECK(client.ask_at("hover", 2, 13)["range"]["start"]["character"] == 12);
    CHECK(client.ask_at("completion", 2, 42).size() > 100);
    CHECK(client.ask_at("documentHighlight", 2, 13).size() == 2);
    CHECK(client.ask("workspace/symbol", {{"query", "si"}})[0]["name"] == "Size");
    CHECK(client.ask_at("definition", 2, 13)[0]["range"]["start"]["line"] == 0);
    CHECK(client.ask_at("references", 2, 13).size() == 2);
    CHECK(client.ask_at("prepareRename", 2, 13)["placeholder"] == "Size");
    CHECK(client.ask_at("prepareRename", 2, 13)["range"]["start"]["character"] == 12);
    CHECK(client.ask_at("prepareRename", 2, 2)["message"] ==
          "only names that a scene declares can be renamed");
    CHECK(client.ask_at("rename", 2, 13, {{"newName", "R"}})["changes"][client.uri].size() == 2);
    CHECK(client.ask_at("rename", 2, 13, {{"newName", "box"}})["message"] ==
          "`box` is a word of the language");
    CHECK(client.ask_at("signatureHelp", 0, 0) == nullptr);
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
    client.tell("textDocument/didChange", {{"textDocument", {{"uri", client.uri}}},
                                           {"contentChanges", {{{"text", client_scene}}}}});
    client.answers.clear();
    client.server.catch_up();
    CHECK(client.answers.at(0)["params"]["diagnostics"].empty());
}

TEST_CASE("an editor is answered while its scene is evaluated, and a change ends the check") {
    Client client;
    client.open(
        "#declare S = \"aaaaaaaaaaaaaaaa\";\n"
        "#for (I, 1, 21) #declare S = concat(S, S); #end\n"
        "#for (I, 1, 1e6) #declare T = concat(S, \"a\"); #end");
    std::array<int, 2> ends;
    REQUIRE(::pipe(ends.data()) == 0);
    REQUIRE(::write(ends[1], "?!", 2) == 2);
    int served = 0;
    const auto serve = [&] {
        char asked;
        REQUIRE(::read(ends[0], &asked, 1) == 1);
        CHECK(client.ask_at("documentSymbol", 0, 0)[0]["name"] == "S");
        if (++served == 2)
            client.tell("textDocument/didChange", {{"textDocument", {{"uri", client.uri}}},
                                                   {"contentChanges", {{{"text", client_scene}}}}});
        client.answers.clear();
        return true;
    };
    const auto begin = std::chrono::steady_clock::now();
    client.server.catch_up({ends[0], serve});
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(5));
    CHECK(served == 2);
    CHECK(client.answers.empty());
    CHECK(client.server.behind());
    client.server.catch_up();
    CHECK(client.answers.at(0)["params"]["diagnostics"].empty());
    for (const int end : ends) ::close(end);
}

TEST_CASE("a misspelt word can be changed to what it was taken to be") {
    Client client;
    client.open("camera { location -5*z }\nshpere { 0, 1 }\n");
    client.server.catch_up();
    const Json mistakes = client.answers.at(0)["params"]["diagnostics"];
    const Json actions =
        client.ask_at("codeAction", 1, 2, {{"context", {{"diagnostics", mistakes}}}});
    REQUIRE(actions.size() == 1);
    CHECK(actions[0]["title"] == "Change to sphere");
    const Json& edit = actions[0]["edit"]["changes"][client.uri][0];
    CHECK(edit["newText"] == "sphere");
    CHECK(edit["range"]["end"]["character"] == 6);
    CHECK(client.ask_at("codeAction", 1, 2)["code"] == -32602);
    CHECK(client.ask_at("codeAction", 1, 2, {{"context", {{"diagnostics", {7}}}}})["code"] ==
          -32602);
    CHECK(client.ask_at("codeAction", 1, 2,
                        {{"context", {{"diagnostics", {Json::object()}}}}})["code"] == -32602);
}

TEST_CASE("odd messages do no harm") {
    Client client;
    for (const char* message :
         {"", "7", "[]", "{", "{}", "{\"method\": 7}", "{\"method\": \"textDocument/hover\"}",
          "{\"method\": \"textDocument/didChange\", \"params\": []}",
          "{\"method\": \"textDocument/didOpen\", \"params\": \"a\"}"})
        client.server.receive(message);
    client.server.catch_up();
    CHECK(client.ask("textDocument/hover")["code"] == -32602);
    CHECK(client.ask("nothing/such")["code"] == -32601);
    CHECK_FALSE(client.server.ended());
}

TEST_CASE("what is no request is refused by its own number") {
    Client client;
    const auto code = [&](const std::string& message) {
        client.answers.clear();
        client.server.receive(message);
        return client.answers.size() == 1 ? client.answers[0]["error"]["code"].get<int>() : 0;
    };
    for (const char* text : {"", "{", "\"\xff\"", "[1e999]", "nul", "{} {}", "\xef\xbb\xbf"}) {
        CAPTURE(text);
        CHECK(code(text) == -32700);
    }
    for (const char* text :
         {"7", "[]", "null", "{}", R"({"method": 7})", R"({"id": 1})", R"([{"method": "exit"}])",
          R"({"id": null, "method": "shutdown"})", R"({"id": [], "method": "shutdown"})",
          R"({"id": 1.5, "method": "shutdown"})", R"({"id": true, "method": "shutdown"})"}) {
        CAPTURE(text);
        CHECK(code(text) == -32600);
        CHECK(client.answers[0]["id"] == (std::string(text) == R"({"id": 1})" ? Json(1) : Json()));
    }
    CHECK(code(R"({"id": 1, "method": "shut\u0000down"})") == -32601);
    for (const char* ignored : {R"({"method": "$/noise"})", R"({"id": 3, "result": null})",
                                R"({"method": "textDocument/hover"})"}) {
        CAPTURE(ignored);
        CHECK(code(ignored) == 0);
        CHECK(client.answers.empty());
    }
    const std::string deep =
        "{\"id\": 1, \"method\": \"shutdown\", \"params\": " + std::string(200'000, '[') +
        std::string(200'000, ']') + "}";
    CHECK(code(deep) == -32600);
    CHECK(client.answers[0]["error"]["message"] == "a message nests at most 64 deep");
    CHECK(code(std::string(200'000, '[')) == -32600);
    client.answers.clear();
    client.server.receive_too_long();
    CHECK(client.answers.at(0)["error"]["code"] == -32600);
    CHECK(client.ask("shutdown") == nullptr);
}

TEST_CASE("each request has its time") {
    Client client(false);
    CHECK(client.ask("textDocument/hover")["code"] == -32002);
    CHECK(client.ask("shutdown")["code"] == -32002);
    client.open(client_scene);
    CHECK_FALSE(client.server.behind());
    CHECK(client.ask("initialize").contains("capabilities"));
    CHECK(client.ask("initialize")["code"] == -32600);
    client.open(client_scene);
    CHECK(client.server.behind());
    CHECK(client.ask("shutdown") == nullptr);
    CHECK(client.ask_at("hover", 0, 0)["code"] == -32600);
    CHECK(client.ask("initialize")["code"] == -32600);
    client.tell("exit", nullptr);
    CHECK(client.server.ended_well());
}

TEST_CASE("a parameter of a wrong type is refused, and nothing is done") {
    Client client;
    client.open(client_scene);
    client.server.catch_up();
    const Json good = {
        {"textDocument", {{"uri", client.uri}, {"text", "a"}}},
        {"position", {{"line", 0}, {"character", 9}}},
        {"newName", "R"},
        {"color", {{"red", 0}, {"green", 0}, {"blue", 0}}},
        {"range",
         {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 0}, {"character", 1}}}}},
        {"contentChanges", {{{"text", "a"}}}}};
    struct Case {
        const char* method;
        std::vector<const char*> read;
    };
    for (const Case& each : {Case{"hover", {"textDocument", "position"}},
                             Case{"completion", {"textDocument", "position"}},
                             Case{"definition", {"textDocument", "position"}},
                             Case{"references", {"textDocument", "position"}},
                             Case{"rename", {"textDocument", "position", "newName"}},
                             Case{"prepareRename", {"textDocument", "position"}},
                             Case{"documentHighlight", {"textDocument", "position"}},
                             Case{"semanticTokens/full", {"textDocument"}},
                             Case{"semanticTokens/range", {"textDocument", "range"}},
                             Case{"inlayHint", {"textDocument", "range"}},
                             Case{"foldingRange", {"textDocument"}},
                             Case{"documentLink", {"textDocument"}},
                             Case{"rangeFormatting", {"textDocument", "range"}},
                             Case{"documentSymbol", {"textDocument"}},
                             Case{"documentColor", {"textDocument"}},
                             Case{"colorPresentation", {"textDocument", "color", "range"}},
                             Case{"formatting", {"textDocument"}},
                             Case{"didOpen", {"textDocument"}},
                             Case{"didChange", {"textDocument", "contentChanges"}},
                             Case{"didSave", {"textDocument"}},
                             Case{"didClose", {"textDocument"}}})
        for (const char* const name : each.read)
            for (const Json& bad : {Json(), Json(7), Json(-1), Json::array(), Json::object(),
                                    Json(true), Json::array({Json::array()})}) {
                CAPTURE(each.method, name, bad.dump());
                Json parameters = good;
                parameters[name] = bad;
                const std::string method = std::string("textDocument/") + each.method;
                CHECK(client.ask(method, parameters)["code"] == -32602);
                client.answers.clear();
                client.tell(method, parameters);
                CHECK(client.answers.size() == (method.find("/did") != method.npos ? 1u : 0u));
                for (const Json& answer : client.answers)
                    CHECK(answer["method"] == "window/logMessage");
            }
    CHECK_FALSE(client.server.behind());
    CHECK(client.ask_at("references", 2, 13).size() == 2);
}

TEST_CASE("documents follow the editor by parts") {
    Client client;
    client.open("a\U0001F4A1b\r\nsphere { 0, 1 }\n");
    const auto change = [&](int line, int from, int to_line, int to, const std::string& text) {
        return Json{{"range",
                     {{"start", {{"line", line}, {"character", from}}},
                      {"end", {{"line", to_line}, {"character", to}}}}},
                    {"text", text}};
    };
    const auto send = [&](const Json& changes) {
        client.answers.clear();
        client.tell("textDocument/didChange",
                    {{"textDocument", {{"uri", client.uri}}}, {"contentChanges", changes}});
        return client.answers.empty();
    };
    // The positions of the second change refer to the text after the first one.
    CHECK(send({change(0, 0, 1, 0, "#declare R = 1;\n"), change(1, 12, 1, 13, "R")}));
    CHECK(client.ask_at("references", 1, 12).size() == 2);
    // If one change of a message is invalid, none is applied.
    CHECK_FALSE(send({change(0, 0, 0, 0, "R "), change(1, 0, 0, 0, "")}));
    CHECK(client.answers[0]["method"] == "window/logMessage");
    CHECK(client.ask_at("references", 1, 12).size() == 2);
    CHECK(send(Json::array({change(2147483647, 0, 2147483647, 2147483647, "R")})));
    CHECK(client.ask_at("references", 1, 12).size() == 3);
}

TEST_CASE("only open documents are asked about") {
    Client client;
    client.folder.put("a.pov", client_scene);
    CHECK(client.ask_at("hover", 2, 13)["message"] ==
          "`" + (client.folder / "a.pov") + "` is not open");
    client.open(client_scene);
    CHECK(client.ask_at("hover", 2, 13).contains("contents"));
    CHECK(client.ask_at("hover", 2147483647, 2147483647) == nullptr);
    client.tell("textDocument/didClose", {{"textDocument", {{"uri", client.uri}}}});
    CHECK(client.ask_at("hover", 2, 13)["code"] == -32602);
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

}  // namespace candelabra
