// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_help.h"

#include "text/ascii.h"
#include "text/message.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

namespace candelabra {

namespace {

using OptionJson = nlohmann::ordered_json;

bool is_offered(const OptionRow& row) { return row.unoffered == Unoffered::no; }

/// The entry as lists have it, with what becomes of an option that is not offered.
ManualEntry listed_entry(const OptionRow& row) {
    ManualEntry entry = manual_entry(row);
    const std::string reason = entry.help.empty() ? "" : ": " + entry.help;
    if (row.unoffered == Unoffered::ignored) entry.help = "ignored with a warning" + reason;
    if (row.unoffered == Unoffered::refused) entry.help = "refused with an error" + reason;
    return entry;
}

/// The entries of a group that has options which are offered.
std::vector<ManualEntry> entries_of(OptionGroup group) {
    std::vector<ManualEntry> entries;
    for (const OptionRow& row : option_table())
        if (row.group == group && is_offered(row)) entries.push_back(listed_entry(row));
    return entries;
}

std::string group_text(const OptionGroupInfo& group) {
    const std::string title = message("Options of the group ", group.name, ": ", group.help);
    return message(wrapped(title, 2), "\n", manual(entries_of(group.group), ManualForm::text));
}

/// The group that a topic such as `film options` or `film_options` names, or null.
const OptionGroupInfo* group_called(std::string_view topic) {
    for (const OptionGroupInfo& group : option_groups())
        for (const char sign : {' ', '_', '-'})
            if (same_letters(topic, message(group.name, sign, "options"))) return &group;
    return nullptr;
}

/// The forms of an option that the short help shows: "+W, --width n".
std::string short_term(const OptionRow& row) {
    const std::string_view before = row.takes == Takes::maybe_value ? "[=" : " ";
    const bool valued = !row.parameter.empty() && row.takes != Takes::sign_and_value;
    const std::string value =
        valued ? message(before, row.parameter, row.takes == Takes::maybe_value ? "]" : "") : "";
    return message(row.letters.empty() ? "" : message('+', row.letters, ", "), "--", long_name(row),
                   value);
}

std::string_view called(Changes changes) {
    switch (changes) {
        case Changes::none:
            return "nothing";
        case Changes::folders:
            return "folders";
        case Changes::format:
            return "file";
        case Changes::samples:
        case Changes::adaptive:
            return "samples";
        case Changes::picture:
            return "picture";
    }
    return {};
}

std::string_view called(OptionGroup group) {
    return option_groups()[static_cast<std::size_t>(group)].name;
}

/// Adds the bounds that there are.
void add_range(OptionJson& json, const Range& range) {
    if (std::isfinite(range.low)) json[range.low_excluded ? "above" : "low"] = range.low;
    if (std::isfinite(range.high)) json["high"] = range.high;
}

/// Adds type, range and default of the option's value.
void add_value(OptionJson& json, const OptionRow& row) {
    if (!row.field.empty()) {
        const Setting setting = find_setting(row.field);
        const FieldType type = setting.info().type;
        json["type"] = type == FieldType::boolean   ? "boolean"
                       : type == FieldType::integer ? "integer"
                                                    : "number";
        add_range(json, setting.info().range);
        const FieldValue usual = setting.item->default_value(setting.field);
        if (const auto* number = std::get_if<double>(&usual)) {
            if (type == FieldType::boolean)
                json["default"] = *number > 0;
            else
                json["default"] = *number;
        }
        return;
    }
    if (!row.own) {
        const bool alone = row.takes == Takes::nothing || row.takes == Takes::sign;
        json["type"] = alone ? "boolean" : "text";
        return;
    }
    json["type"] = type_name(row.own.type);
    add_range(json, row.own.range);
    for (const std::string_view name : row.own.names) json["values"].push_back(name);
    const OptionValue usual = row.own.get(Options());
    if (row.own.type == OptionField::Type::toggle)
        json["default"] = std::get<double>(usual) > 0;
    else if (row.own.type != OptionField::Type::choice && std::holds_alternative<double>(usual))
        json["default"] = std::get<double>(usual) / row.own.unit;
    else if (const std::string text = default_text(row.own); !text.empty())
        json["default"] = text;
}

}  // namespace

std::string short_usage() {
    return "usage: candelabra [option ...] scene.pov\n"
           "       candelabra new [--template name] scene.pov\n"
           "       candelabra merge [+Ofile] [+Fx] [--partial] state.state.exr ...\n"
           "       candelabra develop [-o file] [+Fx] [--exposure stops] ... picture.exr ...\n"
           "       candelabra share [-o page.html] [option ...] scene.pov|picture.exr\n"
           "       candelabra light [--json] [-o diagram.svg] file.ies ...\n"
           "       candelabra fmt [--check] [file ...]\n"
           "       candelabra lsp | describe [--json] [part]\n"
           "Renders a scene written in the manner of POV-Ray, lit by any number of lamps.\n"
           "candelabra --help lists the options; candelabra-scene(5) describes the language.\n";
}

ManualEntry manual_entry(const OptionRow& row) {
    using enum Takes;
    const bool valued = row.takes == value;
    std::string term;
    const auto add = [&](const std::string& piece) { term += (term.empty() ? "" : ", ") + piece; };
    if (!row.letters.empty()) {
        add(message("+", row.letters, row.parameter));
        if (row.takes == sign || row.takes == sign_and_value) add(message("-", row.letters));
    }
    if (!row.keyword.empty()) add(message(row.keyword, "=", valued ? row.parameter : "on"));
    if (const std::string name = long_name(row); !name.empty()) {
        const std::string_view open = row.takes == maybe_value ? "[=" : valued ? " " : " [";
        const bool alone = row.parameter.empty() || row.takes == sign_and_value;
        add(alone ? message("--", name)
                  : message("--", name, open, row.parameter, valued ? "" : "]"));
    }
    if (row.field.empty()) {
        const std::string kind = row.own ? values(row.own) : std::string();
        return {term, kind.empty() ? std::string(row.help) : message(row.help, " (", kind, ")")};
    }
    const Setting setting = find_setting(row.field);
    if (setting.info().type == FieldType::boolean) return {term, std::string(setting.info().help)};
    return {term, message(setting.info().help, " (", values(*setting.item, setting.field), ")")};
}

std::string first_clause(const std::string& help) {
    const std::size_t end = std::min({help.find(';'), help.find(". "), help.find(" (")});
    return help.substr(0, end);
}

std::string short_help() {
    std::vector<std::pair<std::string, std::string>> lines;
    std::size_t width = 0;
    for (const OptionRow& row : option_table())
        if (row.basic) {
            lines.emplace_back(short_term(row), first_clause(manual_entry(row).help));
            width = std::max(width, lines.back().first.size());
        }
    std::string text = message(short_usage(), "\nThe usual options:\n");
    for (const auto& [term, help] : lines) {
        const std::size_t column = width + 4;
        text += message("  ", term, std::string(column - 2 - term.size(), ' '),
                        wrapped(help, column), "\n");
    }
    std::string groups;
    for (const OptionGroupInfo& group : option_groups())
        if (!entries_of(group.group).empty())
            groups += message(groups.empty() ? "" : ", ", group.name);
    return message(
        text, "\n",
        wrapped(message("--help all lists all options, --help film options those of one of the "
                        "groups: ",
                        groups,
                        ". --help with another word explains it: sphere, finish, #for, "
                        "light_octree, +A, --samples, shapes, Light_Ring ..."),
                0),
        "\n");
}

std::string long_help() {
    std::string text = short_usage();
    for (const OptionGroupInfo& group : option_groups())
        if (!entries_of(group.group).empty()) text += message("\n", group_text(group));
    return message(
        text, "\n",
        wrapped(
            "Switches start with + or - (on or off), in either case of letters; of two the "
            "later counts. Keyword=value "
            "is the same option as a word. -- ends the options: what follows is a file name. Exit "
            "status: 0 done, 1 error in "
            "the scene, 2 error in the command line, 3 a file cannot be read or written, 4 "
            "stopped by a signal, with the state kept.",
            0),
        "\n\n",
        wrapped("--help compatibility lists POV-Ray's other options; --help with a word explains "
                "it: sphere, finish, union, #for, light_octree, vrotate, +A, --samples, shapes, "
                "light samplers, Light_Ring, light_arrays.inc ...",
                0),
        "\n");
}

std::string option_manual(ManualForm form, bool offered) {
    if (form == ManualForm::json) return options_as_json(offered, "term");
    if (!offered) {
        std::vector<ManualEntry> entries;
        for (const OptionRow& row : option_table())
            if (!is_offered(row)) entries.push_back(listed_entry(row));
        return manual(entries, form);
    }
    std::string text;
    for (const OptionGroupInfo& group : option_groups()) {
        if (entries_of(group.group).empty()) continue;
        if (form == ManualForm::text) {
            text += message(text.empty() ? "" : "\n", group_text(group));
            continue;
        }
        std::string title(group.name);
        title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
        text += message(".SS ", title, "\n", roff_lines(message("Options for ", group.help, ".")),
                        manual(entries_of(group.group), form));
    }
    return text;
}

std::string options_as_json(bool offered, std::string_view name) {
    OptionJson all = OptionJson::array();
    for (const OptionRow& row : option_table()) {
        if (is_offered(row) != offered) continue;
        const ManualEntry entry = listed_entry(row);
        OptionJson json = {{std::string(name), entry.term}, {"help", entry.help}};
        if (!row.letters.empty()) json["switch"] = row.letters;
        if (!row.keyword.empty()) json["keyword"] = row.keyword;
        if (!long_name(row).empty()) json["long"] = long_name(row);
        json["group"] = called(row.group);
        if (offered) {
            add_value(json, row);
            json["changes"] = called(row.changes);
        }
        all.push_back(std::move(json));
    }
    return all.dump(2) + "\n";
}

std::string option_help(std::string_view topic) {
    if (const OptionGroupInfo* group = group_called(topic)) return group_text(*group);
    std::string_view bare = topic;
    bare.remove_prefix(std::min(bare.find_first_not_of("+-"), bare.size()));
    bare = bare.substr(0, bare.find('='));
    for (const OptionRow& row : option_table())
        if (!bare.empty() && (same_letters(row.letters, bare) || same_letters(row.keyword, bare) ||
                              same_letters(long_name(row), bare)))
            return manual(std::array{manual_entry(row)}, ManualForm::text);
    return {};
}

}  // namespace candelabra
