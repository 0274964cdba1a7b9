// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/block_words.h"

#include "bind/blocks.h"
#include "scene/catalogue.h"
#include "support/script.h"
#include "vocabulary/words.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace candelabra {

namespace {

using BlockNames = std::vector<std::string>;

/// Scenes with each block; @ stands in its braces. What has to be there before other words comes
/// before it.
const std::multimap<std::string_view, std::string>& scenes() {
    static const std::multimap<std::string_view, std::string> all = {
        {"", "@"},
        {"object", "object { sphere { 0, 1 } @ }"},
        {"union", "union { sphere { 0, 1 } sphere { x, 1 } @ }"},
        {"merge", "merge { sphere { 0, 1 } sphere { x, 1 } @ }"},
        {"intersection", "intersection { sphere { 0, 1 } sphere { x, 1 } @ }"},
        {"difference", "difference { sphere { 0, 1 } sphere { x, 1 } @ }"},
        {"light_group", "light_group { light_source { 0, 1 } sphere { x, 1 } @ }"},
        {"sphere", "sphere { 0, 1 @ }"},
        {"box", "box { 0, 1 @ }"},
        {"mesh", "mesh { triangle { 0, x, y } @ }"},
        {"model", "model { @ }"},
        {"triangle", "mesh { triangle { 0, x, y @ } }"},
        {"triangle", "triangle { 0, x, y @ }"},
        {"sphere", "blob { sphere { 0, 1, 1 @ } }"},
        {"photons", "light_source { 0, 1 photons { @ } }"},
        {"photons", "global_settings { photons { @ } }"},
        {"subsurface", "global_settings { subsurface { @ } }"},
        {"torus", "torus { 1, 0.4 @ }"},
        {"blob", "blob { @ }"},
        {"light_source", "light_source { 0, 1 @ }"},
        {"camera", "camera { @ }"},
        {"film", "camera { film { @ } }"},
        {"glare", "camera { film { glare { @ } } }"},
        {"background", "background { @ }"},
        {"sky_sphere", "sky_sphere { @ }"},
        {"fog", "fog { @ }"},
        {"sky_luminance", "sky_luminance { sun <40, 0> @ }"},
        {"rainbow", "rainbow { @ }"},
        {"meter", "meter { @ }"},
        {"media", "media { @ }"},
        {"scattering", "media { scattering { 1, 1 @ } }"},
        {"density", "media { density { @ } }"},
        {"global_settings", "global_settings { @ }"},
        {"radiosity", "global_settings { radiosity { @ } }"},
        {"subsurface", "sphere { 0, 1 finish { subsurface { @ } } }"},
        {"light_sampler", "global_settings { light_sampler { @ } }"},
        {"integrator", "global_settings { integrator { @ } }"},
        {"index", "global_settings { index { @ } }"},
        {"texture", "sphere { 0, 1 texture { @ } }"},
        {"interior_texture", "sphere { 0, 1 interior_texture { @ } }"},
        {"material", "sphere { 0, 1 material { @ } }"},
        {"interior", "sphere { 0, 1 interior { @ } }"},
        {"photons", "sphere { 0, 1 photons { @ } }"},
        {"pigment", "sphere { 0, 1 pigment { @ } }"},
        {"normal", "sphere { 0, 1 normal { @ } }"},
        {"finish", "sphere { 0, 1 finish { @ } }"},
        {"reflection", "sphere { 0, 1 finish { reflection { @ } } }"},
        {"irid", "sphere { 0, 1 finish { irid { @ } } }"},
        {"microfacet", "sphere { 0, 1 finish { microfacet { @ } } }"},
        {"warp", "sphere { 0, 1 pigment { bozo warp { @ } } }"},
        {"clipped_by", "sphere { 0, 1 clipped_by { @ } }"},
        {"bounded_by", "sphere { 0, 1 bounded_by { @ } }"},
        {"looks_like", "light_source { 0, 1 looks_like { @ } }"},
        {"projected_through", "light_source { 0, 1 projected_through { @ } }"},
        {"tiles", "sphere { 0, 1 texture { tiles { @ } } }"},
        {"transform", "sphere { 0, 1 transform { @ } }"},
        {"pigment_map", "sphere { 0, 1 pigment { bozo pigment_map { [0 @] [1 rgb 1] } } }"},
        {"normal_map", "sphere { 0, 1 normal { bozo normal_map { [0 @] [1 bumps 1] } } }"},
        {"texture_map",
         "sphere { 0, 1 texture { bozo texture_map { [0 @] [1 pigment { rgb 1 }] } } }"},
    };
    return all;
}

/// Whether the block has a place for this text, whatever may be missing behind it.
bool takes(std::string scene, std::string_view before, std::string_view word,
           std::string_view behind) {
    scene.insert(0, "#version 3.8;\n");
    scene.replace(scene.find('@'), 1,
                  std::string(before) + " " + std::string(word) + " " + std::string(behind));
    const std::string quoted = "`" + std::string(word) + "`";
    for (const Diagnostic& each : run(scene).said) {
        const std::string& text = each.message;
        if (text.find("has no word " + quoted) != text.npos ||
            text.find(quoted + " has no place") != text.npos ||
            text.find("a declared object comes first in") != text.npos ||
            text.find(quoted + " is not available") != text.npos ||
            text.find(quoted + " has no effect in") != text.npos ||
            text.find("is declared as " + quoted) != text.npos ||
            text.find(quoted + " is a word of the language, and has no place") != text.npos)
            return false;
    }
    return true;
}

/// Whether the block takes the word: at once, or behind the kind whose field it is, or behind a
/// pattern.
bool takes(std::string_view block, std::string_view word, const std::vector<BlockWord>& own) {
    std::vector<std::string> beginnings = {""};
    for (const BlockWord& each : own)
        if (each.word == word && each.field) beginnings.emplace_back(each.item->name);
    const auto [first, last] = scenes().equal_range(block);
    for (auto scene = first; scene != last; ++scene) {
        std::vector<std::string> before = beginnings;
        for (const char* sign : {"pigment {", "normal {", "texture {", "density {", "_map"})
            if (scene->second.find(sign) != std::string::npos)
                before.insert(before.end(), {"bozo", "checker"});
        for (const std::string& each : before)
            for (const char* behind : {"", "{ }"})
                if (takes(scene->second, each, word, behind)) return true;
    }
    return false;
}

std::set<std::string> words_of(std::string_view block) {
    std::set<std::string> words;
    for (const BlockWord& each : block_words(block)) words.emplace(each.word);
    return words;
}

}  // namespace

TEST_CASE("each block takes the words that the table says, and no other words of blocks",
          "[bind][slow]") {
    for (const auto& [block, scene] : scenes()) {
        const std::vector<BlockWord> own = block_words(block);
        const std::set<std::string> words = words_of(block);
        std::set<std::string> candidates = words;
        for (const BlockRow& row : block_table().rows()) candidates.emplace(row.word);
        candidates.emplace("sphere");
        CAPTURE(block);
        std::string missing, surplus;
        for (const std::string& word : candidates) {
            const bool taken = takes(block, word, own);
            if (taken && !words.contains(word)) missing += " " + word;
            if (!taken && words.contains(word)) surplus += " " + word;
        }
        CHECK(missing == "");
        CHECK(surplus == "");
    }
}

TEST_CASE("each block that a word belongs in is tried here", "[bind]") {
    std::set<std::string> tried;
    for (const auto& [block, scene] : scenes()) tried.emplace(block);
    for (const BlockRow& row : block_table().rows())
        for (const std::string_view home : block_table().homes(row.word)) {
            INFO(row.word << " in " << home);
            CHECK(tried.contains(std::string(home)));
        }
}

TEST_CASE("messages name the usual homes of a word, words of blocks come once", "[bind]") {
    CHECK(block_table().homes("pigment") == std::vector<std::string_view>{"texture"});
    CHECK(block_table().homes("emission") ==
          std::vector<std::string_view>{"finish", "sky_sphere", "media"});
    CHECK(block_table().homes("subsurface") ==
          std::vector<std::string_view>{"finish", "global_settings", "radiosity"});
    CHECK(block_table().homes("torus").empty());
    CHECK(block_table().homes("nothing").empty());
    CHECK(block_words("nothing").empty());
    for (const auto& [block, scene] : scenes())
        CHECK(words_of(block).size() == block_words(block).size());
    CHECK(block_words("camera").front().word == "location");
    CHECK(block_words("pigment_map").size() == block_words("pigment").size());
}

}  // namespace candelabra
