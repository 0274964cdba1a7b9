// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/textmate.h"

#include "scene/catalogue.h"
#include "text/message.h"
#include "vocabulary/words.h"

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <set>

namespace candelabra {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// Returns `\b(?:one|two)\b`.
std::string any_of(const std::set<std::string_view>& words) {
    std::string all;
    for (const std::string_view word : words) all += message(all.empty() ? "" : "|", word);
    return message("\\b(?:", all, ")\\b");
}

std::set<std::string_view> words_of(std::initializer_list<WordClass> classes) {
    std::set<std::string_view> found;
    for (const Word& word : reserved_words())
        for (const WordClass each : classes)
            if (word.word_class == each) found.insert(word.spelling);
    return found;
}

/// Returns reserved words, and the item names that only this language has.
std::set<std::string_view> item_words() {
    auto words = words_of({WordClass::word, WordClass::layer});
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items)
            if (item->name.find(' ') == item->name.npos) words.insert(item->name);
    return words;
}

OrderedJson coloured(std::string_view scope, const std::string& match) {
    return {{"name", message(scope, ".pov")}, {"match", match}};
}

}  // namespace

std::string textmate_grammar() {
    using enum WordClass;
    const OrderedJson comment = {
        {"name", "comment.block.pov"},
        {"begin", "/\\*"},
        {"end", "\\*/"},
        {"patterns", OrderedJson::array({{{"include", "#block_comment"}}})}};
    const OrderedJson text = {
        {"name", "string.quoted.double.pov"},
        {"begin", "\""},
        {"end", "\""},
        {"patterns", OrderedJson::array({coloured("constant.character.escape", "\\\\.")})}};
    const std::string directives =
        message("#\\s*", any_of(words_of({WordClass::directive})).substr(2));
    const OrderedJson macro = {{"match", "(#\\s*macro)\\s+([A-Za-z_][A-Za-z0-9_]*)"},
                               {"captures",
                                {{"1", {{"name", "keyword.control.directive.pov"}}},
                                 {"2", {{"name", "entity.name.function.pov"}}}}}};
    OrderedJson patterns = OrderedJson::array(
        {{{"include", "#block_comment"}},
         coloured("comment.line.double-slash", "//.*$"),
         text,
         macro,
         coloured("keyword.control.directive", directives),
         coloured("constant.numeric", "\\b(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?"),
         coloured("constant.language", any_of(words_of({constant}))),
         coloured("support.function", any_of(words_of({unary_function, function}))),
         coloured("support.type.colour", any_of(words_of({colour, colour_prefix, channel}))),
         coloured("storage.type", any_of(words_of({array, function_literal}))),
         coloured("keyword.other", any_of(item_words())),
         coloured("keyword.operator", "[-+*/=<>&|!?:]")});
    const OrderedJson grammar = {{"name", "POV scene"},
                                 {"scopeName", "source.pov"},
                                 {"fileTypes", {"pov", "inc"}},
                                 {"patterns", std::move(patterns)},
                                 {"repository", {{"block_comment", comment}}}};
    return grammar.dump(2) + "\n";
}

}  // namespace candelabra
