// SPDX-License-Identifier: GPL-3.0-or-later
// The examples of words that help, hover, the manual and the book show: each renders, and there is
// one for each word that stands in a block.
#include "vocabulary/examples.h"
#include "bind/blocks.h"
#include "objects/object_functions.h"
#include "scene/catalogue.h"
#include "support/shell.h"
#include "vocabulary/glossary.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

namespace candelabra {

namespace {

std::vector<std::string_view> all_examples() {
    std::vector<std::string_view> all;
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items)
            all.insert(all.end(), item->examples.begin(), item->examples.end());
    for (const GlossaryEntry& entry : glossary())
        for (const std::string_view example : entry.examples)
            if (!example.empty()) all.push_back(example);
    return all;
}

bool stands_in(std::string_view block, const BlockRow& row) {
    return contains_word(row.homes, block);
}

/// The example in a scene with a camera and a light, unless it has its own.
std::string scene_around(std::string_view example) {
    const std::string_view first = example.substr(0, example.find(' '));
    const BlockRow* row = block_table().row(first);
    std::string text(example);
    if (row && !row->in_scene && stands_in("object", *row)) text = "sphere { y, 1 " + text + " }";
    if (row && !row->in_scene && !stands_in("object", *row) && stands_in("camera", *row))
        text = "camera { location <0, 2.4, -6> look_at y " + text + " }";
    std::string scene = "#version 3.7;\n";
    if (!has(text, "assumed_gamma")) scene += "global_settings { assumed_gamma 1 }\n";
    if (!has(text, "camera {")) scene += "camera { location <0, 2.4, -6> look_at y }\n";
    if (!has(text, "light_source {")) scene += "light_source { <-4, 6, -8>, rgb 1 }\n";
    return scene + "plane { y, -2 pigment { rgb 0.5 } }\n" + text + "\n";
}

/// Whether all warnings are of words that POV-Ray knows and that have no effect here, or of names
/// that are to be avoided.
bool harmless(std::string_view said) {
    for (std::size_t at = said.find("warning["); at != said.npos;
         at = said.find("warning[", at + 1))
        if (!said.substr(at).starts_with("warning[no-effect]") &&
            !said.substr(at).starts_with("warning[deprecated]"))
            return false;
    return true;
}

/// Words whose values are files, which examples do not have, and functions of one shape.
const std::set<std::string_view> unshown = {
    "gif",        "tga",        "pgm",       "ppm",       "bmp",      "jpeg",     "tiff", "exr",
    "hdr",        "sys",        "file",      "exp",       "ln",       "asin",     "sinh", "cos",
    "asinh",      "acos",       "cosh",      "acosh",     "tan",      "atan",     "tanh", "ies",
    "road_table", "ldt",        "aim",       "atanh",     "c0",       "mirrored", "sin",  "cube",
    "lamp_set",   "reciprocal", "hierarchy", "save_file", "load_file"};

}  // namespace

TEST_CASE("each example of a word renders", "[manual]") {
    Shell shell;
    shell.library = std::string(CANDELABRA_SOURCE_DIR) + "/stdlib";
    for (const std::string_view example : all_examples()) {
        INFO(example);
        shell.write("example.pov", scene_around(example));
        std::vector<std::string> words = {
            shell.path("example.pov"),   "+W8", "+H6", "--samples", "1", "+WT1", "+FP",
            "+O" + shell.path("out.ppm")};
        // Files are not written by checks, which warn of that.
        if (contains_word(example, "fopen"))
            words.insert(words.end(), {"--check", "--warn", "none"});
        const int status = shell(words);
        CAPTURE(shell.err);
        CHECK(status == 0);
        CHECK(harmless(shell.err));
    }
}

TEST_CASE("each item has an example, and each of its words is in one of the item or its kin",
          "[manual]") {
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items) {
            INFO(group.name << ": " << item->name);
            REQUIRE_FALSE(item->examples.empty());
            const bool is_word = item->name != "pattern";  // which stands for any pattern
            CHECK((!is_word || contains_word(example_of(item->name, item->examples), item->name)));
            for (const FieldInfo& field : item->fields) {
                if (!field.is_word() || unshown.contains(field.name)) continue;
                INFO(field.name);
                CHECK(std::ranges::any_of(group.items, [&](const ItemInfo* kin) {
                    return contains_word(example_of(field.name, kin->examples), field.name);
                }));
            }
        }
}

TEST_CASE("each word of the table of blocks is in an example", "[manual]") {
    const std::vector<std::string_view> all = all_examples();
    for (const BlockRow& row : block_table().rows()) {
        INFO(row.word);
        CHECK(contains_word(example_of(row.word, all), row.word));
    }
}

TEST_CASE("each function has an example, and its value", "[manual]") {
    Shell shell;
    shell.write("lamps.csv", "name,x,y\none,0,1\ntwo,3,1.5\n");
    shell.write("lamps.json", R"({ "lamps": [{ "radiance": 3 }] })");
    for (const FunctionInfo& each : all_functions()) {
        INFO(each.name << ": " << each.example);
        CHECK(contains_word(each.example, each.name));
        const std::string_view arrow = " -> ";
        const std::size_t end = each.example.find(arrow);
        std::string text(each.example.substr(0, end));
        if (end != each.example.npos) {
            const std::string value(each.example.substr(end + arrow.size()));
            const bool words = value.starts_with('"');
            const std::string differs =
                words ? "strcmp(Made, Stated) != 0" : "vlength((Made - Stated)*<1, 1, 1>) > 1e-6";
            text = "#declare Made = " + text + "; #declare Stated = " + value + ";\n#if (" +
                   differs + ") #error \"another value\" #end\n";
        }
        shell.write("function.pov", scene_around(text));
        const int status =
            shell({shell.path("function.pov"), "+W8", "+H6", "--samples", "1", "-F", "-V"});
        CAPTURE(shell.err);
        CHECK(status == 0);
        CHECK(harmless(shell.err));
    }
}

TEST_CASE("each entry of the glossary with an effect has an example", "[manual]") {
    for (const GlossaryEntry& entry : glossary()) {
        INFO(entry.words);
        const bool without = has(std::string(entry.help), "without effect") ||
                             has(std::string(entry.help), "not available") ||
                             entry.words == "steps";
        CHECK(entry.examples.front().empty() == without);
    }
}

}  // namespace candelabra
