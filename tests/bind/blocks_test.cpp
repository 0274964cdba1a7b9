// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/blocks.h"

#include "scene/catalogue.h"
#include "scene/dump.h"
#include "support/script.h"
#include "vocabulary/glossary.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

namespace candelabra {

namespace {

/// Contents of the braces of each block that is a value or belongs to a scene.
const std::map<std::string_view, std::string> samples = {
    {"union", "sphere { 0, 1 } sphere { x, 1 }"},
    {"intersection", "sphere { 0, 1 } sphere { x, 1 }"},
    {"difference", "sphere { 0, 1 } sphere { x, 1 }"},
    {"merge", "sphere { 0, 1 } sphere { x, 1 }"},
    {"composite", "sphere { 0, 1 } sphere { x, 1 }"},
    {"light_group", "light_source { y, 1 } sphere { 0, 1 }"},
    {"object", "sphere { 0, 1 }"},
    {"light_source", "y, rgb 1"},
    {"model", "file \"a.off\""},
    {"camera", "location -5*z"},
    {"background", "rgb <0, 0, 1>"},
    {"sky_sphere", "pigment { rgb 1 }"},
    {"fog", "distance 10 rgb 1"},
    {"sky_luminance", "overcast sun <40, 180>"},
    {"rainbow", "direction z angle 40 width 5 distance 100 color_map { [0 rgb 0] [1 rgb 1] }"},
    {"meter", "\"desk\" corner -x along 2*x across 3*z counts <4, 3>"},
    {"media", "emission 1 density { bozo } scattering { 1, 0.5 }"},
    {"density", "rgb 0.5"},
    {"density_map", "[0 rgb 0] [1 rgb 1]"},
    {"global_settings", "max_trace_level 7"},
    {"texture", "pigment { rgb 1 }"},
    {"material", "texture { pigment { rgb 1 } }"},
    {"interior", "ior 1.5"},
    {"transform", "translate x"},
    {"pigment", "rgb 1"},
    {"normal", "bumps 0.5"},
    {"finish", "phong 1"},
    {"texture_map", "[0 pigment { rgb 0 }] [1 pigment { rgb 1 }]"},
    {"color_map", "[0 rgb 0] [1 rgb 1]"},
    {"colour_map", "[0 rgb 0] [1 rgb 1]"},
    {"pigment_map", "[0 rgb 0] [1 rgb 1]"},
    {"normal_map", "[0 bumps 1] [1 dents 1]"},
    {"slope_map", "[0 <0, 1>] [1 <1, 0>]"},
};

/// What the samples read.
const std::map<std::string, std::string> sample_files = {
    {"a.off", "OFF\n3 1 0\n0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n"}};

std::string sample(std::string_view word) {
    INFO("a sample of " << word);
    const auto found = samples.find(word);
    REQUIRE(found != samples.end());
    return std::string(word) + " { " + found->second + " }";
}

bool in_catalogue(std::string_view word) {
    const auto tells = [&](const ItemInfo* item) {
        return item->name == word || std::ranges::any_of(item->fields, [&](const FieldInfo& field) {
                   return field.name == word;
               });
    };
    return std::ranges::any_of(catalogue(), [&](const ItemGroup& group) {
        return std::ranges::any_of(group.items, tells);
    });
}

}  // namespace

TEST_CASE("each word has one row, and is explained", "[bind]") {
    std::vector<std::string_view> words;
    for (const BlockRow& row : block_table().rows()) {
        INFO(row.word);
        words.push_back(row.word);
        CHECK((glossary_entry(row.word) || in_catalogue(row.word)));
    }
    std::ranges::sort(words);
    CHECK(std::ranges::adjacent_find(words) == words.end());
}

TEST_CASE("the row of a word is found by its number", "[bind]") {
    Names names;
    for (const BlockRow& row : block_table().rows()) {
        INFO(row.word);
        if (names.reserved(names.intern(row.word)))
            CHECK(block_table().row(names.find(row.word)) == &row);
        const bool own = block_table().scene_row(row.word) == &row && !row.as_value;
        if (row.in_scene || row.as_value)
            CHECK((own || block_table().row(names.find(row.word)) == &row));
    }
    CHECK(block_table().row(names.intern("not_a_block")) == nullptr);
    CHECK(block_table().row(no_name) == nullptr);
    CHECK(block_table().scene_row("meter") != nullptr);
    CHECK(block_table().scene_row("luminaire") == nullptr);
    CHECK(block_table().makes_object(names.find("torus")));
    CHECK(block_table().takes_braces(names.find("torus")));
    CHECK_FALSE(block_table().combines_objects(names.find("torus")));
    CHECK(block_table().combines_objects(names.find("merge")));
    CHECK_FALSE(block_table().makes_object(names.find("finish")));
    CHECK(block_table().takes_braces(names.find("finish")));
    CHECK_FALSE(block_table().takes_braces(names.find("translate")));
}

TEST_CASE("what a scene holds is written, and reads back as the same", "[bind]") {
    for (const BlockRow& row : block_table().rows()) {
        if (!row.in_scene) continue;
        const Script done = run("#version 3.7; " + sample(row.word), sample_files);
        INFO(row.word << '\n' << done.text);
        CHECK(done.text.empty());
        const std::string text = dump(done.scene);
        CHECK(dump(run(text).scene) == text);
        const auto texts = scene_texts();
        const auto found = std::ranges::find(texts, row.word, &SceneText::word);
        CHECK((row.makes_object() || found != texts.end()));
        if (found == texts.end()) continue;
        CHECK(found->text(done.scene).find(row.word) != std::string::npos);
        CHECK(text.find(found->text(done.scene)) != std::string::npos);
    }
}

TEST_CASE("what is a value can be declared, and is called by its name", "[bind]") {
    for (const BlockRow& row : block_table().rows()) {
        if (!row.as_value) continue;
        const Script done =
            run("#version 3.7; #declare A = " + sample(row.word) + " #declare B = A + 1;",
                sample_files);
        INFO(row.word << '\n' << done.text);
        REQUIRE(done.said.size() == 1);
        std::string name = row.makes_object() && row.word != "light_source" ? "object"
                           : row.word == "color_map"                        ? "colour map"
                           : row.word == "density"                          ? "pigment"
                           : row.word == "density_map"                      ? "pigment map"
                                                                            : std::string(row.word);
        std::ranges::replace(name, '_', ' ');
        CHECK(done.said[0].message.find(' ' + name) != std::string::npos);
    }
}

TEST_CASE("what is a default can be set", "[bind]") {
    for (const BlockRow& row : block_table().rows()) {
        if (!row.as_default) continue;
        INFO(row.word);
        CHECK(run("#version 3.7; #default { " + sample(row.word) + " }").text.empty());
    }
}

}  // namespace candelabra
