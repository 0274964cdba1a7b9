// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/suggestions.h"

#include "support/edited.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Where the text is among the suggestions at the sign |; -1: nowhere.
int rank(const std::string& text, std::string_view wanted) {
    Edited edited(text);
    edited.folder.put("mine.inc", "");
    const auto all = suggestions(edited.workspace, edited.path, edited.offset);
    const auto found = std::ranges::find(all, wanted, &Suggestion::text);
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

}  // namespace

TEST_CASE("what the block takes comes before names, and names before other words") {
    const std::string text = "#declare Rough = 1; #macro Make(A) #end sphere { 0, 1 finish { | } }";
    CHECK(rank(text, "roughness") >= 0);
    CHECK(rank(text, "roughness") < rank(text, "Rough"));
    CHECK(rank(text, "Make") >= 0);
    CHECK(rank(text, "Rough") < rank(text, "vrotate"));
    CHECK(rank("camera { | }", "fisheye") >= 0);
    CHECK(rank("camera { | }", "fisheye") < rank("camera { | }", "sphere"));
    CHECK(rank("#include \"colors.inc\"\n| ", "Orange") >= 0);
}

TEST_CASE("behind # come directives, in the quotes of #include files") {
    CHECK(rank("#dec|", "declare") >= 0);
    CHECK(rank("#dec|", "sphere") == -1);
    CHECK(rank("#include \"|", "mine.inc") == 0);
    CHECK(rank("#include \"|", "colors.inc") > 0);
    CHECK(rank("#include \"mine.inc\" |", "sphere") > 0);
}

TEST_CASE("locals of other files are not suggested") {
    Edited edited("|");
    edited.workspace.open(edited.folder / "b.inc", "#macro M(Inner) #end #local L = 1;");
    std::string names;
    for (const Suggestion& each : suggestions(edited.workspace, edited.path, 0))
        if (each.kind == Suggestion::name || each.kind == Suggestion::macro)
            names += each.text + " ";
    CHECK(names == "M ");
}

}  // namespace candelabra
