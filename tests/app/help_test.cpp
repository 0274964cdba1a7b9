// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help.h"

#include "editor/library_guide.h"
#include "objects/object_functions.h"
#include "options/option_help.h"
#include "options/option_table.h"
#include "scene/catalogue.h"
#include "support/shell.h"
#include "text/ascii.h"
#include "vocabulary/words.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <set>

namespace candelabra {

namespace {

const std::string stdlib = CANDELABRA_SOURCE_DIR "/stdlib";

std::string help(std::string_view topic) {
    Diagnostics diagnostics;
    std::string text = help_text(topic, stdlib, diagnostics);
    for (const Diagnostic& each : diagnostics.all())
        text += "! " + each.message + " | " + each.help;
    return text;
}

}  // namespace

TEST_CASE("the overview names every option that is offered, and no other") {
    const std::string text = help("all");
    for (const OptionRow& row : option_table()) {
        CAPTURE(row.letters, row.keyword, row.word);
        const std::string term = "  " + manual_entry(row).term;
        CHECK((has(text, term + " ") || has(text, term + "\n")) ==
              (row.unoffered == Unoffered::no));
    }
    std::size_t start = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\n') continue;
        CAPTURE(text.substr(start, i - start));
        CHECK(i - start <= 80);
        start = i + 1;
    }
}

TEST_CASE("each row of help can be read by itself") {
    // Texts that lean on the row before them. The usage before a colon in the glossary is no text.
    const std::regex leans(R"(\b(the same|those|as above)\b|^(it|its|they|these|this|such|also)\b)",
                           std::regex::icase);
    Diagnostics diagnostics;
    const auto all = nlohmann::json::parse(description("", ManualForm::json, stdlib, diagnostics));
    std::size_t count = 0;
    const std::function<void(const nlohmann::json&)> check = [&](const nlohmann::json& part) {
        if (part.is_object() && part.contains("help")) {
            std::string help = part["help"];
            const std::size_t usage = part.contains("term") ? help.find(": ") : help.npos;
            if (usage != help.npos) help.erase(0, usage + 2);
            INFO(part.dump());
            CHECK_FALSE(std::regex_search(help, leans));
            ++count;
        }
        for (const auto& each : part)
            if (each.is_structured()) check(each);
    };
    check(all);
    CHECK(count > 1000);
}

TEST_CASE("topics are items, groups, functions and options") {
    CHECK(has(help("sphere"), "sphere { centre, radius }"));
    CHECK(has(help("Sphere"), "sphere { centre, radius }"));
    CHECK(has(help("light samplers"), "light_octree"));
    CHECK(has(help("light_samplers"), "linear_alpha"));
    CHECK(has(help("light_octree"), "threshold"));
    CHECK(has(help("vrotate"), "vrotate("));
    CHECK(has(help("+W"), "+Wn, Width=n"));
    CHECK(has(help("--width"), "+Wn, Width=n, --width n"));
    CHECK(has(help("animation options"), "--frames list"));
    CHECK(has(help(""), "The usual options:"));
    CHECK(help("options") == help("all"));
    CHECK(has(help("Width"), "+Wn, Width=n"));
    CHECK(has(help("#while"), "#while (condition)"));
    CHECK(has(help("union"), "union { objects modifiers }"));
    CHECK(has(help("camera"), "--help cameras"));
    CHECK(has(help("anisotropy"), "not available"));
    CHECK(has(help("max_trace_level"), "in global_settings"));
    CHECK(has(help("--samples"), "--samples n"));
    CHECK(has(help("compatibility"), "+UF, -UF, Field_Render=on, --field-render"));
    CHECK(has(help("Light_Ring"),
              "Light_Ring(Lamp object or array[], Count whole >= 1, Radius > 0)\n"));
    CHECK(has(help("Light_Ring"), "#include \"light_arrays.inc\""));
    CHECK(has(help("light_arrays.inc"), "Light_Matrix("));
    const std::string arrays = help("light_arrays.inc");
    CHECK(arrays.find("Light_Matrix(") < arrays.find("Light_Rule_Pitch("));
    CHECK(has(help("sunpos"), "SunPos(Year"));
    CHECK(has(help("luminaires"), "global_settings { luminaires above 0.5 }"));
    CHECK(has(help("light_sampler"), "global_settings { light_sampler"));
    CHECK(has(help("povray.conf"), "--allow-read FOLDER"));
    CHECK(has(help("povray.ini"), "candelabra povray.ini scene.pov"));
    CHECK(has(help("candelabra.ini"), "CANDELABRA_INI"));
    CHECK(has(help("Light_Rnig"), "did you mean `Light_Ring`?"));
    CHECK(has(help("shpere"), "did you mean `sphere`?"));
    CHECK(help("shpere") == "! there is no help on `shpere` | did you mean `sphere`?");
    CHECK(help("qqqqqq") == "! there is no help on `qqqqqq` | --help all lists the options");
}

TEST_CASE("descriptions exist in all parts and forms") {
    for (const char* part : {"", "items", "functions", "glossary", "library", "macros", "options",
                             "compatibility", "words"}) {
        for (const ManualForm form : {ManualForm::text, ManualForm::roff, ManualForm::json}) {
            CAPTURE(part);
            Diagnostics diagnostics;
            const std::string text = description(part, form, stdlib, diagnostics);
            CHECK(diagnostics.all().empty());
            CHECK(text.size() > 500);
            CHECK(text.back() == '\n');
            if (form == ManualForm::json) CHECK_FALSE(nlohmann::json::parse(text).empty());
        }
    }
    Diagnostics diagnostics;
    CHECK(has(description("missing", ManualForm::text, stdlib, diagnostics), "not available"));
    CHECK(diagnostics.all().empty());
    CHECK(description("colours", ManualForm::text, stdlib, diagnostics).empty());
    CHECK(diagnostics.error_count() == 1);
}

namespace {

/// Returns the manual pages of scenes and of the library with their parts included.
std::string page_of_scenes() {
    std::string page;
    for (const char* name : {"candelabra-scene.5", "candelabra-stdlib.7"}) {
        std::ifstream file(CANDELABRA_SOURCE_DIR "/man/" + std::string(name) + ".in");
        page.append(std::istreambuf_iterator<char>(file), {});
    }
    for (const std::string part : {"functions", "glossary", "items", "macros"}) {
        Diagnostics diagnostics;
        std::string place = "@" + part + "@";
        std::ranges::transform(place, place.begin(),
                               [](unsigned char c) { return std::toupper(c); });
        const std::size_t at = page.find(place);
        REQUIRE(at != std::string::npos);
        page.replace(at, place.size(), description(part, ManualForm::roff, stdlib, diagnostics));
    }
    std::string text;
    for (std::size_t i = 0; i < page.size(); ++i)
        if (page[i] != '\\') text += page[i];
    return text;
}

bool has_word(const std::string& text, const std::string& word) {
    const auto in_word = [&](std::size_t i) {
        return i < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_');
    };
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        if ((at == 0 || !in_word(at - 1)) && !in_word(at + word.size())) return true;
    return false;
}

/// Returns every word that a scene may contain, and every file and macro of the library.
std::set<std::string> words_of_scenes() {
    std::set<std::string> words;
    for (const Word& word : reserved_words())
        if (in_name(word.spelling.front())) words.emplace(word.spelling);
    for (const FunctionInfo& each : all_functions()) words.emplace(each.name);
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items) {
            words.emplace(item->name);
            for (const FieldInfo& field : item->fields)
                if (!field.unnamed() && field.place != Placement::following)
                    words.emplace(field.name);
        }
    for (const LibraryFile& file : library_guide(stdlib)) {
        words.insert(file.name);
        for (const LibraryMacro& macro : file.macros) words.insert(macro.name);
    }
    for (const char* each : {"light_sampler", "luminaires", "index"}) words.emplace(each);
    return words;
}

}  // namespace

TEST_CASE("--help and the manual of scenes know every word, file and macro") {
    const std::string page = page_of_scenes();
    const std::set<std::string> words = words_of_scenes();
    CHECK(words.size() > 750);
    std::set<std::string> unlisted;  // parts of the library's files and not for scenes
    for (const LibraryFile& file : library_guide(stdlib))
        for (const LibraryMacro& macro : file.macros)
            if (!macro.listed) unlisted.insert(macro.name);
    for (const std::string& word : words) {
        CAPTURE(word);
        CHECK_FALSE(help(word).starts_with("! "));
        CHECK((has_word(page, word) || unlisted.contains(word)));
    }
    for (const char* each : {"#fopen", "#read", "#write", "#fclose"}) CHECK(has(page, each));
}

TEST_CASE("help shows an example that has the word") {
    CHECK(has(help("torus"), "\n  e.g. torus { 1, 0.4 rotate -30*x translate 0.9*y }\n"));
    CHECK(has(help("phong_size"), "e.g. finish { phong 0.9 phong_size 60 }"));
    CHECK(has(help("Light_Ring"), "e.g. object { Light_Ring(Bulb, 24, 1.4) translate 0.5*y }"));
    CHECK(has(help("VDist"), "e.g. VDist(<1, 2, 3>, <1, 2, 5>) -> 2"));
    CHECK(has(help("no_shadow"), "e.g. sphere { y, 1 no_shadow }"));
    CHECK(has(help("while"), "e.g. #declare I = 0; #while"));
    Diagnostics diagnostics;
    const std::string all = description("examples", ManualForm::text, stdlib, diagnostics);
    CHECK(has(all, "\nfinish { phong 0.9 phong_size 60 }\n"));
    CHECK(std::ranges::count(all, '\n') > 300);
}

}  // namespace candelabra
