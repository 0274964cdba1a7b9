// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library_manual.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candelabra {

TEST_CASE("the library's part of the manual has its files and the macros for scenes") {
    const LibraryGuide guide = {library_file("lamps.inc", R"(// Lamps of all kinds.
//
//   Ring(Lamp, Count)       around y
//       e.g. Ring(Bulb, 3) -> 4
#macro Ring(Lamp, Count) Ring_Rule(Count) #end
#macro Ring_Rule(Count) #end
)"),
                                library_file("words.inc", R"(// Words - and no list
// ... at all.

#macro Word() "a" #end
)")};
    CHECK(library_manual(guide, ManualForm::text) ==
          "lamps.inc: Lamps of all kinds.\n"
          "  Ring(Lamp, Count)       around y\n"
          "                          e.g. Ring(Bulb, 3) -> 4\n"
          "\nwords.inc: Words - and no list ... at all.\n"
          "  Word()                  a macro of words.inc\n");
    CHECK(
        library_manual(guide, ManualForm::roff) ==
        ".SS lamps.inc\nLamps of all kinds.\n.TP\n.B Ring(Lamp, Count)\naround y\n"
        ".br\n\\f(CRRing(Bulb, 3) \\-> 4\\fR\n"
        ".SS words.inc\nWords \\- and no list ... at all.\n.TP\n.B Word()\na macro of words.inc\n");
    const auto json = nlohmann::json::parse(library_manual(guide, ManualForm::json));
    REQUIRE(json.size() == 2);
    CHECK(json[0]["file"] == "lamps.inc");
    const auto macros = nlohmann::json::parse(
        R"json([{"name": "Ring", "form": "Ring(Lamp, Count)", "help": "around y",
                "example": "Ring(Bulb, 3)", "value": "4"}])json");
    CHECK(json[0]["macros"] == macros);
}

}  // namespace candelabra
