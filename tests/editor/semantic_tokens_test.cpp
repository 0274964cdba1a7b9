// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/semantic_tokens.h"

#include "support/edited.h"

#include <filesystem>

namespace candelabra {

namespace {

/// Returns "word:kind" for each token, with ! at declarations and * for the library's.
std::string meant(const std::string& text) {
    Edited edited(text);
    edited.folder.put("b.inc", "#declare Shared = 1;");
    std::string all;
    for (const SemanticToken& each : semantic_tokens(edited.workspace, edited.path)) {
        all += std::string(edited.workspace.file(edited.path)->part(each.place)) + ":" +
               std::string(semantic_kinds()[each.kind]);
        if (each.modifiers & SemanticToken::declaration) all += "!";
        if (each.modifiers & SemanticToken::of_library) all += "*";
        all += " ";
    }
    return all;
}

}  // namespace

TEST_CASE("names are coloured by their declarations") {
    CHECK(meant("#declare A = 1; A") == "#declare:keyword A:variable! 1:number A:variable ");
    CHECK(meant("#macro M(B) B #end M(1) B") ==
          "#macro:keyword M:macro! B:parameter! B:parameter #end:keyword M:macro 1:number ");
    CHECK(meant("#include \"b.inc\" Shared Unknown") ==
          "#include:keyword \"b.inc\":string Shared:variable ");
    CHECK(meant("#include \"colors.inc\" Red").ends_with("Red:variable* "));
}

TEST_CASE("words are coloured by their use") {
    CHECK(meant("sphere { x, sin(1) hollow }") ==
          "sphere:type x:enumMember sin:function 1:number hollow:property ");
    CHECK(meant("light_sampler { }") == "light_sampler:type ");
    CHECK(meant("rgb <1, 2, 3> /* a */ // b") ==
          "rgb:property <1, 2, 3>:number /* a */:comment // b:comment ");
}

TEST_CASE("tokens lie within lines") {
    CHECK(meant("/* a\r\n b */ 1") == "/* a:comment  b */:comment 1:number ");
    CHECK(meant("\"a\n\nb\"") == "\"a:string b\":string ");
    CHECK(meant("").empty());
    Edited edited;
    CHECK(semantic_tokens(edited.workspace, "/none/such.pov").empty());
}

TEST_CASE("in the library and the examples nearly all words are known, each at its place") {
    namespace fs = std::filesystem;
    int names = 0, known = 0;
    for (const char* folder : {"stdlib", "examples/gallery", "examples/lights"})
        for (const auto& entry : fs::directory_iterator(fs::path(CANDELABRA_SOURCE_DIR) / folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".pov" && ending != ".inc") continue;
            Workspace workspace(CANDELABRA_SOURCE_DIR "/stdlib");
            const std::string path = entry.path().string();
            std::uint32_t end = 0;
            CAPTURE(path);
            for (const SemanticToken& each : semantic_tokens(workspace, path)) {
                CHECK(each.place.first >= end);
                CHECK(each.place.last > each.place.first);
                end = each.place.last;
                known += each.kind >= SemanticToken::macro;
            }
            CHECK(end <= workspace.file(path)->text.size());
            for (const Token& token : workspace.file(path)->tokens)
                names += token.kind == TokenKind::name;
        }
    CHECK(names > 10'000);
    CHECK(known > names * 9 / 10);
}

}  // namespace candelabra
