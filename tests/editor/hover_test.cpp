// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hover.h"

#include "support/edited.h"

namespace candelabra {

namespace {

std::string hovering(const std::string& text) {
    Edited edited(text);
    const auto found = hover(edited.workspace, edited.path, edited.offset);
    return found ? found->text : "";
}

bool says(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

}  // namespace

TEST_CASE("names show their declaration and the comment above it") {
    const std::string text = hovering(
        "// Not this.\n\n// How wide\n//  it is.\n#declare Width = 2; // m\nbox { 0, Wid|th }");
    CHECK(text == "```pov\n#declare Width = 2; // m\n```\nHow wide\nit is.\n\nin `a.pov`");
    CHECK(says(hovering("#include \"colors.inc\"\nsphere { 0, 1 pigment { Orang|e } }"),
               "in `colors.inc`"));
    CHECK(hovering("Nowhe|re").empty());
    CHECK(hovering("#include \"light_arrays.inc\"\nobject { Light_R|ing(A, 2, 3) }") ==
          "```pov\nLight_Ring(Lamp object or array[], Count whole >= 1, Radius > 0)\n```\naround "
          "y, the lamp's +x outwards\n\n"
          "```pov\nobject { Light_Ring(Bulb, 24, 1.4) translate 0.5*y }\n```\n"
          "in `light_arrays.inc`");
}

TEST_CASE("words show what the vocabulary says of them, in the block that they stand in") {
    CHECK(says(hovering("sphe|re { 0, 1 }"), "sphere { centre, radius }"));
    CHECK(says(hovering("sphere { 0, 1 finish { rough|ness 0.1 } }"), "in `finish`"));
    CHECK(says(hovering("sphere { 0, 1 finish { rough|ness 0.1 } }"),
               "```pov\nfinish { specular 0.9 roughness 0.02 }\n```"));
    CHECK(says(hovering("sph|ere { 0, 1 }"), "e.g. sphere { y, 1 }"));
    CHECK(says(hovering("#whi|le (A) #end"), "```pov\n#declare I = 0; #while (I < 5)"));
    CHECK(says(hovering("camera { orthogra|phic }"), "camera { orthographic"));
    CHECK(says(hovering("#declare A = vrot|ate(x, y);"), "vrotate("));
    CHECK(hovering("sphere { 0, 1 |   }").empty());
    CHECK(hovering("|").empty());
}

TEST_CASE("the blocks around a place are told from those that have ended") {
    Edited edited("union { sphere { 0, 1 } texture { finish { | } } }");
    const FileHandle file = edited.workspace.file(edited.path);
    std::string names;
    for (const NameId each : blocks_around(*file, edited.offset))
        names += std::string(edited.workspace.names().spelling(each)) + " ";
    CHECK(names == "finish texture union ");
}

}  // namespace candelabra
