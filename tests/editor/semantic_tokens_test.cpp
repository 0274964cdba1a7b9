// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/semantic_tokens.h"

#include "support/edited.h"

namespace candelabra {

namespace {

/// "word:kind" of each, with ! at declarations and * for the library's.
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

}  // namespace candelabra
