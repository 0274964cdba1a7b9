// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/symbols.h"

#include "support/edited.h"

namespace candelabra {

namespace {

std::string found(Edited& edited, std::string_view query) {
    std::string all;
    for (const Symbol& each : symbols(edited.workspace, query))
        all += each.name + (each.is_macro ? "() " : " ");
    return all;
}

}  // namespace

TEST_CASE("names are found by some of their letters") {
    Edited edited("#include \"b.inc\"\n#declare Table = 1; #local Tail = 2; #macro Stable(A) #end");
    edited.folder.put("b.inc", "#declare Tar = 1; #declare Box_Table = 2;");
    CHECK(found(edited, "") == "Table Stable() Tar Box_Table ");
    CHECK(found(edited, "ta") == "Table Tar Stable() Box_Table ");
    CHECK(found(edited, "TBL") == "Table Stable() Box_Table ");
    CHECK(found(edited, "xyz").empty());
    CHECK(symbols(edited.workspace, "tar").at(0).path == edited.folder / "b.inc");
    Edited none;
    CHECK(found(none, "a").empty());
}

TEST_CASE("the library's names for scenes come behind the scene's own") {
    Edited edited("#include \"light_arrays.inc\"\n#macro My_Light_Ring() #end");
    CHECK(found(edited, "") == "My_Light_Ring() ");
    CHECK(found(edited, "light_ring").starts_with("Light_Ring() My_Light_Ring() "));
    CHECK(found(edited, "_temp").empty());
}

TEST_CASE("there are at most a thousand") {
    std::string text;
    for (int i = 0; i < 1500; ++i) text += "#declare A" + std::to_string(i) + " = 1;\n";
    Edited edited(text);
    CHECK(symbols(edited.workspace, "").size() == 1000);
    CHECK(symbols(edited.workspace, "1499").size() == 1);
}

}  // namespace candelabra
