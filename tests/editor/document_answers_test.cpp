// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/client.h"

namespace candelabra {

namespace {

Json lines_range(int first, int first_character, int last, int last_character) {
    return {{"start", {{"line", first}, {"character", first_character}}},
            {"end", {{"line", last}, {"character", last_character}}}};
}

}  // namespace

TEST_CASE("the outline has whole declarations") {
    Client client;
    client.open("#macro M(A)\nA\n#end\n#declare B =\n1;\n#local C = 2;");
    const Json outline = client.ask_at("documentSymbol", 0, 0);
    REQUIRE(outline.size() == 2);
    CHECK(outline[0]["range"] == lines_range(0, 0, 2, 4));
    CHECK(outline[0]["selectionRange"] == lines_range(0, 7, 0, 8));
    CHECK(outline[0]["kind"] == 12);
    CHECK(outline[1]["range"] == lines_range(3, 0, 4, 2));
}

TEST_CASE("meanings of words are numbers relative to the word before") {
    Client client;
    client.open("/* \U0001F4A1 */ 1\n  A\n#declare A = 2;");
    const Json legend =
        Client(false).ask("initialize")["capabilities"]["semanticTokensProvider"]["legend"];
    CHECK(legend["tokenTypes"][10] == "variable");
    const Json whole = client.ask_at("semanticTokens/full", 0, 0)["data"];
    CHECK(whole == Json({0, 0, 8, 0, 0, 0, 9, 1, 3,  0, 1, 2, 1, 10, 0,  //
                         1, 0, 8, 1, 0, 0, 9, 1, 10, 1, 0, 4, 1, 3,  0}));
    const Json part =
        client.ask_at("semanticTokens/range", 0, 0, {{"range", lines_range(1, 0, 1, 9)}})["data"];
    CHECK(part == Json({1, 2, 1, 10, 0}));
}

TEST_CASE("folds, links and highlights are given in lines and URIs") {
    Client client;
    client.folder.put("b c.inc", "");
    client.open("#include \"b c.inc\"\nunion {\n#declare A = 1;\nA }\n}\n");
    CHECK(client.ask_at("foldingRange", 0, 0)[0] ==
          Json({{"startLine", 1}, {"endLine", 2}, {"kind", "region"}}));
    const Json links = client.ask_at("documentLink", 0, 0);
    REQUIRE(links.size() == 1);
    CHECK(links[0]["range"] == lines_range(0, 10, 0, 17));
    CHECK(links[0]["target"].get<std::string>().ends_with("/b%20c.inc"));
    const Json lit = client.ask_at("documentHighlight", 3, 0);
    REQUIRE(lit.size() == 2);
    CHECK(lit[0] == Json({{"range", lines_range(2, 9, 2, 10)}, {"kind", 3}}));
    CHECK(lit[1]["kind"] == 2);
}

TEST_CASE("names of parameters stand before arguments") {
    Client client;
    client.open("#macro Post(Height, Colour) #end\nPost(1,\n  2)\n");
    CHECK(client.ask_at("inlayHint", 0, 0, {{"range", lines_range(1, 0, 2, 0)}}) ==
          Json::array({{{"position", {{"line", 1}, {"character", 5}}},
                        {"label", "Height:"},
                        {"kind", 2},
                        {"paddingRight", true}}}));
}

TEST_CASE("widgets of a scene are listed") {
    Client client;
    client.open("// [Tree]\n#ifndef (Tall) #declare Tall = 2; #end // 0 to 5 by 0.5: how tall it is\n"
                "#ifndef (Tint) #declare Tint = rgb <1, 0.5, 0>; #end // colour\n"
                "#ifndef (Kind) #declare Kind = \"fir\"; #end // one of \"fir\", \"oak\"\n");
    const Json found = client.ask("candelabra/knobs", {{"textDocument", {{"uri", client.uri}}}});
    REQUIRE(found.size() == 3);
    CHECK(found[0] == Json{{"name", "Tall"},
                           {"kind", "slider"},
                           {"value", 2.0},
                           {"low", 0.0},
                           {"high", 5.0},
                           {"step", 0.5},
                           {"choices", Json::array()},
                           {"help", "how tall it is"},
                           {"section", "Tree"}});
    CHECK(found[1]["kind"] == "colour");
    CHECK(found[1]["value"] == Json::array({1.0, 0.5, 0.0}));
    CHECK(found[2]["choices"] == Json::array({"fir", "oak"}));
    CHECK(client.ask("candelabra/knobs")["code"] == -32602);
}

TEST_CASE("names of the workspace are found in all its files") {
    Client client;
    client.folder.put("b.inc", "\n#declare Shared = 1;");
    client.open("#include \"b.inc\"\n");
    const Json found = client.ask("workspace/symbol", {{"query", "shar"}});
    REQUIRE(found.size() == 1);
    CHECK(found[0]["containerName"] == "b.inc");
    CHECK(found[0]["location"]["range"] == lines_range(1, 9, 1, 15));
    CHECK(client.ask("workspace/symbol")["code"] == -32602);
    CHECK(client.ask("workspace/symbol", {{"query", 7}})["code"] == -32602);
}

TEST_CASE("lines of a range are laid out") {
    Client client;
    client.open("union {\nA\n  B\n}\n");
    const Json edits = client.ask_at("rangeFormatting", 0, 0, {{"range", lines_range(1, 0, 1, 1)}});
    REQUIRE(edits.size() == 1);
    CHECK(edits[0]["range"] == lines_range(1, 0, 2, 0));
    CHECK(edits[0]["newText"] == "    A\n");
    CHECK(client.ask_at("rangeFormatting", 0, 0, {{"range", lines_range(0, 0, 0, 1)}}) ==
          Json::array());
    CHECK(client.ask_at("rangeFormatting", 0, 0, {{"range", lines_range(2, 0, 1, 0)}})["code"] ==
          -32602);
    CHECK(client.ask_at("formatting", 0, 0).size() == 1);
}

TEST_CASE("colours are shown and chosen") {
    Client client;
    client.open("rgb <1, 0, 0>");
    const Json colours = client.ask_at("documentColor", 0, 0);
    REQUIRE(colours.size() == 1);
    const Json other = {{"red", 0}, {"green", 1}, {"blue", 0}};
    CHECK(client.ask_at("colorPresentation", 0, 0,
                        {{"color", other}, {"range", colours[0]["range"]}})[0]["label"] ==
          "rgb <0, 1, 0>");
}

}  // namespace candelabra
