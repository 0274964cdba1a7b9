// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help.h"

#include "app/library_manual.h"
#include "editor/library_guide.h"
#include "editor/textmate.h"
#include "objects/object_functions.h"
#include "options/option_help.h"
#include "options/option_table.h"
#include "production/version.h"
#include "scene/catalogue.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"
#include "vocabulary/examples.h"
#include "vocabulary/glossary.h"
#include "vocabulary/words.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace candelabra {

namespace {

using OrderedJson = nlohmann::ordered_json;

bool same_topic(std::string_view name, std::string_view topic) {
    std::string spaced(topic);
    std::ranges::replace(spaced, '_', ' ');
    return same_letters(name, topic) || same_letters(name, spaced);
}

/// Whether a comma-separated list contains the name.
bool has_name(std::string_view list, std::string_view name) {
    return message(", ", list, ", ").find(message(", ", name, ", ")) != std::string::npos;
}

std::string example_line(std::string_view example) {
    return example.empty() ? "" : message("  e.g. ", wrapped(example, 4), "\n");
}

std::string glossary_help(std::string_view topic) {
    const GlossaryEntry* const entry = glossary_entry(topic);
    return entry ? message(wrapped(entry->form, 4), "\n  ", wrapped(entry->help, 2), "\n",
                           example_line(example_of(topic, entry->examples)))
                 : std::string();
}

/// Returns an example of the item, or of its kin, that has the word of a field; empty if there is
/// none.
std::string_view example_with(std::string_view field, const ItemInfo& item,
                              const ItemGroup& group) {
    const std::string_view own = example_of(field, item.examples);
    if (contains_word(own, field)) return own;
    for (const ItemInfo* other : group.items)
        if (const std::string_view kin = example_of(field, other->examples);
            contains_word(kin, field))
            return kin;
    return {};
}

/// Returns the meaning of a field's name in each item that has it.
std::string field_help(std::string_view topic) {
    std::vector<ManualEntry> meanings;
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items)
            for (std::size_t i = 0; i < item->fields.size(); ++i) {
                const FieldInfo& field = item->fields[i];
                if (!same_letters(field.name, topic) || field.unnamed()) continue;
                const std::string help = message(field.help, " (", values(*item, i), ")");
                const auto same = std::ranges::find(meanings, help, &ManualEntry::help);
                if (same == meanings.end())
                    meanings.push_back({std::string(item->name), help,
                                        std::string(example_with(field.name, *item, group))});
                else if (!has_name(same->term, item->name))
                    same->term += message(", ", item->name);
            }
    std::string text;
    for (const ManualEntry& each : meanings)
        text += message("in ", wrapped(each.term, 4), ":\n  ", wrapped(each.help, 2), "\n",
                        example_line(each.example));
    return text;
}

/// Returns help on the group, or on all items, of that name.
std::string item_help(std::string_view topic) {
    std::string text;
    for (const ItemGroup& group : catalogue()) {
        if (same_topic(group.name, topic)) return manual(std::span(&group, 1), ManualForm::text);
        for (const ItemInfo* item : group.items)
            if (same_letters(item->name, topic))
                text += message(text.empty() ? "" : "\n", manual(*item, group.block));
    }
    return text;
}

std::string macro_help(const LibraryMacro& macro, std::string_view file) {
    const ManualEntry entry = manual_entry(macro, file);
    return message(wrapped(entry.term, 4), "\n  ", wrapped(entry.help, 2), "\n",
                   example_line(entry.example), "  in ", file, ": #include \"", file, "\"\n");
}

/// Returns help on a file of the library, or on a macro in it.
std::string library_help(std::string_view topic, const LibraryGuide& library) {
    std::string text;
    for (const LibraryFile& file : library) {
        if (same_letters(file.name, topic) || same_letters(file.name, message(topic, ".inc"))) {
            std::vector<ManualEntry> macros;
            // Aids of the others come last.
            for (const bool listed : {true, false})
                for (const LibraryMacro& each : file.macros)
                    if (each.listed == listed) macros.push_back(manual_entry(each, file.name));
            text += message("#include \"", file.name, "\"\n  ", wrapped(file.about, 2), "\n",
                            manual(macros, ManualForm::text));
        }
        for (const LibraryMacro& each : file.macros)
            if (same_letters(each.name, topic)) text += macro_help(each, file.name);
    }
    return text;
}

std::vector<std::string_view> topics(const LibraryGuide& library) {
    std::vector<std::string_view> names = {"all", "options", "compatibility", "warnings"};
    for (const ItemGroup& group : catalogue()) {
        names.push_back(group.name);
        for (const ItemInfo* item : group.items) names.push_back(item->name);
    }
    for (const LibraryFile& file : library) {
        names.push_back(file.name);
        for (const LibraryMacro& each : file.macros) names.push_back(each.name);
    }
    for (const FunctionInfo& each : all_functions()) names.push_back(each.name);
    for (const Word& word : reserved_words()) names.push_back(word.spelling);
    for (const OptionRow& row : option_table()) {
        if (!row.keyword.empty()) names.push_back(row.keyword);
        if (!row.word.empty()) names.push_back(row.word);
    }
    return names;
}

std::vector<ManualEntry> function_entries() {
    std::vector<ManualEntry> result;
    for (const FunctionInfo& each : all_functions())
        result.push_back({message(each.name, "(", each.arguments, ")"), std::string(each.help),
                          std::string(each.example)});
    return result;
}

/// Returns the words of the glossary; directives have their `#`.
std::vector<ManualEntry> glossary_entries() {
    std::vector<ManualEntry> result;
    for (const GlossaryEntry& entry : glossary()) {
        std::string term;
        for (std::string_view rest = entry.words; !rest.empty();) {
            const std::string_view word = take_until(rest, " ");
            const auto known = std::ranges::find(reserved_words(), word, &Word::spelling);
            const bool directive =
                known != reserved_words().end() && known->word_class == WordClass::directive;
            term += message(term.empty() ? "" : ", ", directive ? "#" : "", word);
        }
        result.push_back(
            {term, message(entry.form, ": ", entry.help), std::string(entry.examples.front())});
    }
    return result;
}

/// The examples of all items and words, each on a line.
std::string all_examples(ManualForm form) {
    std::vector<std::string_view> all;
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items)
            all.insert(all.end(), item->examples.begin(), item->examples.end());
    for (const GlossaryEntry& entry : glossary())
        for (const std::string_view example : entry.examples)
            if (!example.empty()) all.push_back(example);
    if (form == ManualForm::json) return OrderedJson(all).dump(2) + "\n";
    std::string text;
    for (const std::string_view example : all) text += message(example, "\n");
    return text;
}

std::vector<ManualEntry> library_entries(const std::string& folder) {
    std::vector<ManualEntry> result;
    for (const LibraryFile& file : library_guide(folder)) {
        result.push_back({file.name, file.about});
        for (const LibraryMacro& each : file.macros)
            result.push_back(manual_entry(each, file.name));
    }
    return result;
}

/// Returns the features of POV-Ray that this version lacks.
std::vector<ManualEntry> missing_entries() {
    std::vector<ManualEntry> result;
    for (ManualEntry& entry : glossary_entries())
        if (!says_available(entry.help)) result.push_back(std::move(entry));
    return result;
}

std::vector<ManualEntry> warning_entries() {
    std::vector<ManualEntry> result;
    for (const FaultInfo& fault : all_faults())
        if (!fault.warns_of.empty())
            result.push_back({std::string(fault.name), std::string(fault.warns_of)});
    return result;
}

std::string_view class_name(WordClass word_class) {
    switch (word_class) {
        case WordClass::name:
            return "name";
        case WordClass::layer:
        case WordClass::word:
            return "word";
        case WordClass::unary_function:
        case WordClass::function:
            return "function";
        case WordClass::constant:
            return "constant";
        case WordClass::colour:
        case WordClass::colour_prefix:
            return "colour";
        case WordClass::channel:
            return "channel";
        case WordClass::array:
            return "array";
        case WordClass::function_literal:
            return "function_literal";
        case WordClass::directive:
            return "directive";
    }
    return {};
}

/// The reserved words by class.
OrderedJson json_words() {
    OrderedJson all = OrderedJson::object();
    for (const Word& word : reserved_words())
        all[std::string(class_name(word.word_class))].push_back(word.spelling);
    return all;
}

std::string words(ManualForm form) {
    const OrderedJson all = json_words();
    if (form == ManualForm::json) return all.dump(2) + "\n";
    std::vector<ManualEntry> list;
    for (const auto& [name, spellings] : all.items()) {
        std::string text;
        for (const auto& spelling : spellings)
            text += message(text.empty() ? "" : " ", spelling.get<std::string>());
        list.push_back({name, text});
    }
    return manual(list, form);
}

/// Help on the files that say what each run does; empty if there is none of this name.
std::string settings_help(std::string_view topic) {
    constexpr std::string_view own = "candelabra.ini";
    if (same_letters(topic, "povray.conf"))
        return message(
            "povray.conf\n  ",
            wrapped("POV-Ray's file of the folders that scenes may read and write, which is not "
                    "read. A scene reads below its own folder and the library: --allow-read FOLDER "
                    "adds one. It writes data to a folder beside its picture: --allow-write FOLDER "
                    "adds one.",
                    2),
            "\n");
    if (!same_letters(topic, "povray.ini") && !same_letters(topic, own)) return {};
    return message(topic, "\n  ",
                   wrapped(message(same_letters(topic, own)
                                       ? ""
                                       : "POV-Ray's file of the options of each run, which is read "
                                         "where it is named: candelabra povray.ini scene.pov. ",
                                   "Options of each run stand in the file that CANDELABRA_INI "
                                   "names, in ~/.config/candelabra/candelabra.ini or in "
                                   "/etc/candelabra/candelabra.ini: the first that exists."),
                           2),
                   "\n");
}

}  // namespace

std::string help_text(std::string_view topic, const std::string& library,
                      Diagnostics& diagnostics) {
    if (topic.empty()) return short_help();
    if (same_letters(topic, "all") || same_letters(topic, "options")) return long_help();
    if (same_letters(topic, "compatibility")) return option_manual(ManualForm::text, false);
    if (same_letters(topic, "warnings")) return manual(warning_entries(), ManualForm::text);
    std::string text = item_help(topic);
    for (const FunctionInfo& each : all_functions())
        if (same_letters(each.name, topic))
            text += message(each.name, "(", each.arguments, ")\n  ", wrapped(each.help, 2), "\n",
                            example_line(each.example));
    const LibraryGuide guide = library_guide(library);
    for (const std::string& more : {glossary_help(topic), field_help(topic), option_help(topic),
                                    library_help(topic, guide), settings_help(topic)}) {
        if (!text.empty() && !more.empty()) text += "\n";
        text += more;
    }
    if (text.empty()) {
        const std::string meant = nearest(topic, topics(guide));
        diagnostics.add(
            error(Fault::option, {}, message("there is no help on `", printable(topic), "`"))
                .with_help(meant.empty() ? "--help all lists the options"
                                         : message("did you mean `", meant, "`?")));
    }
    return text;
}

std::string description(std::string_view part, ManualForm form, const std::string& library,
                        Diagnostics& diagnostics) {
    if (part == "items") return manual(catalogue(), form);
    if (part == "options") return option_manual(form, true);
    if (part == "compatibility") return option_manual(form, false);
    if (part == "functions") return manual(function_entries(), form);
    if (part == "glossary") return manual(glossary_entries(), form);
    if (part == "library") return manual(library_entries(library), form);
    if (part == "macros") return library_manual(library_guide(library), form);
    if (part == "examples") return all_examples(form);
    if (part == "missing") return manual(missing_entries(), form);
    if (part == "words") return words(form);
    if (part == "warnings") return manual(warning_entries(), form);
    if (part == "textmate") return textmate_grammar();
    if (!part.empty()) {
        diagnostics.add(
            error(Fault::option, {},
                  message("there is nothing called `", printable(part), "` to describe"))
                .with_help("items, functions, glossary, examples, library, macros, options, "
                           "compatibility, "
                           "missing, words, warnings or textmate"));
        return {};
    }
    if (form != ManualForm::json) return manual(catalogue(), form);
    OrderedJson all = {{"program", "candelabra"},
                       {"version", version()},
                       {"options", OrderedJson::parse(options_as_json(true, "option"))},
                       {"words", json_words()}};
    all["functions"] = OrderedJson::parse(manual(function_entries(), form));
    all["glossary"] = OrderedJson::parse(manual(glossary_entries(), form));
    all["groups"] = OrderedJson::parse(manual(catalogue(), form));
    all["library"] = OrderedJson::parse(library_manual(library_guide(library), form));
    all["warnings"] = OrderedJson::parse(manual(warning_entries(), form));
    return all.dump(2) + "\n";
}

}  // namespace candelabra
