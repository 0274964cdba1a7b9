// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/suggestions.h"

#include "bind/block_words.h"
#include "bind/blocks.h"
#include "scene/catalogue.h"
#include "support/edited.h"

#include <algorithm>
#include <set>

namespace candelabra {

namespace {

/// Rank of the text among the suggestions at |; -1 if it is missing.
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

TEST_CASE("in every block its own words come first, and those of blocks around it do not") {
    std::set<std::string> blocks = {""};
    for (const BlockRow& row : block_table().rows()) {
        blocks.emplace(row.word);
        for (const std::string_view home : block_table().homes(row.word)) blocks.emplace(home);
    }
    for (const ItemGroup& group : catalogue()) {
        if (!group.block.empty()) blocks.emplace(group.block);
        for (const ItemInfo* item : group.items)
            if (group.block.empty()) blocks.emplace(item->name);
    }
    const std::string names = "#declare Bulb = 1; ";
    for (const std::string& block : blocks) {
        const std::string braces = block.empty() ? "|" : block + " { | }";
        for (const std::string& text :
             {names + braces, names + "camera { film { " + braces + " } }"}) {
            if (block.empty() && text.size() > names.size() + 1) continue;
            CAPTURE(text);
            Edited edited(text);
            const auto all = suggestions(edited.workspace, edited.path, edited.offset);
            const auto own = block_words(block);
            REQUIRE(all.size() > own.size());
            for (std::size_t i = 0; i < own.size(); ++i) CHECK(all[i].text == own[i].word);
            CHECK(all[own.size()].text == "Bulb");
        }
    }
    CHECK(rank("camera { | }", "location") == 0);
    CHECK(rank("camera { film { | } }", "glare") < 20);
    CHECK(rank("global_settings { | }", "luminaires") < 30);
    CHECK(rank("interior { | }", "media") < 20);
    CHECK(rank("media { | }", "scattering") < 30);
    CHECK(rank("light_source { 0, 1 | }", "looks_like") < 40);
    CHECK(rank("difference { | }", "cutaway_textures") < 70);
    CHECK(rank("mesh { triangle { | } }", "texture") < 10);
    CHECK(rank("union { | }", "light_name") == 0);
}

TEST_CASE("the block's words come first, then the scene's names, then the library's") {
    const std::string text =
        "#include \"light_arrays.inc\"\n#declare Bulb = 1; #macro Mine(A) A #end sphere { 0, 1 | }";
    CHECK(rank(text, "pigment") >= 0);
    CHECK(rank(text, "pigment") < rank(text, "Bulb"));
    CHECK(rank(text, "no_shadow") < rank(text, "Bulb"));
    CHECK(rank(text, "translate") < rank(text, "Mine"));
    CHECK(rank(text, "Bulb") < rank(text, "Light_Ring"));
    CHECK(rank(text, "Mine") < rank(text, "Light_Ring"));
    CHECK(rank(text, "Light_Ring") < rank(text, "vrotate"));
    for (const char* aid : {"Light_Nth_", "I_", "Light_Arrays_Inc_Temp", "Light_Column"})
        CHECK(rank(text, aid) == -1);
    CHECK(rank("#declare Bulb = 1; |", "camera") < rank("#declare Bulb = 1; |", "Bulb"));
    CHECK(rank("#declare Bulb = 1; |", "sphere") < rank("#declare Bulb = 1; |", "Bulb"));
    CHECK(rank("union { |", "sphere") < 60);
    CHECK(rank("#declare A_ = 1; sphere { | }", "A_") >= 0);
}

TEST_CASE("a library macro is suggested with its parameters and what it does") {
    Edited edited("#include \"light_arrays.inc\"\n|");
    const auto all = suggestions(edited.workspace, edited.path, edited.offset);
    const auto ring = std::ranges::find(all, "Light_Ring", &Suggestion::text);
    REQUIRE(ring != all.end());
    CHECK(ring->detail == "Light_Ring(Lamp object or array[], Count whole >= 1, Radius > 0)");
    CHECK(ring->help == "around y, the lamp's +x outwards");
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
