// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library_guide.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a library file says what its macros do") {
    const LibraryFile file = library_file("lamps.inc", R"(// SPDX-License-Identifier: CC0-1.0
// Lamps of all
// kinds.
//
//   Ring(Lamp, Count)       around y, the lamp's
//                           +x outwards
//   Red_Lamp(Size)  Blue_Lamp(Size)   of glass
//   Bare(A)
//
// More about it.

#macro Ring(Lamp, Count) 1 #end
#macro Red_Lamp(Size) 2 #end
    #macro Blue_Lamp(Size,
                     More) 3 #end
// Not in the list,
// but here.
#macro Bare(A) 4 #end
#macro Inner_() 5 #end
// ---- other ------
#macro Other() 6 #end
)");
    CHECK(file.about == "Lamps of all kinds.");
    std::string text;
    for (const LibraryMacro& each : file.macros)
        text += each.name + " | " + each.form + " | " + each.help + (each.listed ? "\n" : " -\n");
    CHECK(text ==
          "Ring | Ring(Lamp, Count) | around y, the lamp's +x outwards\n"
          "Red_Lamp | Red_Lamp(Size) | of glass\n"
          "Blue_Lamp | Blue_Lamp(Size, More) | of glass\n"
          "Bare | Bare(A) | Not in the list, but here.\n"
          "Other | Other() |  -\n");
    const LibraryFile bare =
        library_file("a.inc", "// About.\n#macro B() 2 #end\n#macro A_Part() 3 #end");
    CHECK(bare.macros.at(0).listed);
    CHECK_FALSE(bare.macros.at(1).listed);
}

TEST_CASE("an example stands below its macro, and may go on in further lines") {
    const LibraryFile file = library_file("lamps.inc", R"(// About.
//
//   Ring(Lamp, Count)       around y
//       e.g. object { Ring(Bulb,
//         2) }
//   Red(Size)  Blue(Size)   numbers
//       e.g. Blue(2) -> 4, 5
//       e.g. Red(3)

#macro Ring(Lamp, Count) 1 #end
#macro Red(Size) 2 #end
#macro Blue(Size) 3 #end
// Not in the list.
// e.g. Bare(7)
#macro Bare(A) 4 #end
#macro Plain(A) 5 #end
)");
    std::string text;
    for (const LibraryMacro& each : file.macros)
        text += each.help + " | " + each.example + " | " + each.value + "\n";
    CHECK(text ==
          "around y | object { Ring(Bulb, 2) } | \n"
          "numbers | Red(3) | \n"
          "numbers | Blue(2) | 4, 5\n"
          "Not in the list. | Bare(7) | \n"
          " |  | \n");
}

TEST_CASE("the guide has the include files in order") {
    const LibraryGuide guide = library_guide(CANDELABRA_SOURCE_DIR "/stdlib");
    REQUIRE(guide.size() > 30);
    CHECK(guide.front().name == "arrays.inc");
    for (const LibraryFile& file : guide) {
        CAPTURE(file.name);
        CHECK(file.about.size() > 10);
    }
    CHECK(library_guide("/no/such/folder").empty());
    CHECK(library_guide("").empty());
}

TEST_CASE("aids of a library are not for scenes") {
    const LibraryFile file = library_file("a.inc", "#macro Ring() #end\n#macro A_Aid() #end\n");
    CHECK(is_for_scenes(file, "Ring", true));
    CHECK_FALSE(is_for_scenes(file, "A_Aid", true));
    CHECK(is_for_scenes(file, "Size", false));
    CHECK_FALSE(is_for_scenes(file, "Size_", false));
    CHECK_FALSE(is_for_scenes(file, "A_Temp", false));
}

}  // namespace candelabra
