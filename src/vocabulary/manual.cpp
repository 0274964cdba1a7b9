// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/manual.h"

#include "text/message.h"
#include "vocabulary/written.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t term_width = 26;  ///< column of explanations in plain text

std::string_view name_of(FieldType type) {
    switch (type) {
        case FieldType::number:
            return "number";
        case FieldType::integer:
            return "whole number";
        case FieldType::boolean:
            return "on or off";
        case FieldType::vector2:
            return "vector of 2";
        case FieldType::vector3:
            return "vector";
        case FieldType::vector4:
            return "vector of 4";
        case FieldType::rgb:
        case FieldType::colour:
            return "colour";
        case FieldType::text:
            return "string";
        case FieldType::numbers:
            return "list of numbers";
        case FieldType::points:
            return "list of vectors of 2";
        case FieldType::vectors:
            return "list of vectors";
        case FieldType::balls:
            return "list of vectors with a number each";
        case FieldType::faces:
            return "list of <index, index, index>";
        case FieldType::function:
            return "function";
        case FieldType::parts:
            return "block";
    }
    return {};
}

std::string_view name_of(Placement place) {
    switch (place) {
        case Placement::positional:
            return "positional";
        case Placement::item:
            return "item";
        case Placement::flag:
            return "flag";
        case Placement::list:
            return "list";
        case Placement::counted:
            return "counted";
        case Placement::choice:
            return "choice";
        case Placement::following:
            return "following";
        case Placement::parts:
            return "parts";
        case Placement::loose_part:
            return "loose part";
    }
    return {};
}

std::string limits(const Range& range) {
    if (range.any_sign) return ", whose sign does not count";
    const bool low = range.low > -std::numeric_limits<double>::infinity();
    const bool high = range.high < std::numeric_limits<double>::infinity();
    if (low && high && !range.low_excluded) return message(" from ", range.low, " to ", range.high);
    std::string text;
    if (low)
        text = message(range.low_excluded ? " above " : " from ", range.low,
                       range.low_excluded ? "" : " on");
    if (high) text += message(low ? " to " : " up to ", range.high);
    return text;
}

/// The default of the field as text; empty for lists, which are empty by default.
std::string default_text(const ItemInfo& item, std::size_t field) {
    const FieldInfo& info = item.fields[field];
    switch (info.type) {
        case FieldType::numbers:
        case FieldType::points:
        case FieldType::vectors:
        case FieldType::balls:
        case FieldType::faces:
        case FieldType::parts:
            return {};
        default:
            break;
    }
    const FieldValue value = item.default_value(field);
    if (info.place == Placement::choice)
        return std::get<double>(value) == info.chosen ? "on" : "off";
    return written(value, info.type);
}

/// The letter that stands for a value of this type.
char letter(FieldType type) {
    return type == FieldType::number || type == FieldType::integer ? 'n' : 'v';
}

/// The field as written in its item.
std::string form(const FieldInfo& field) {
    const std::string name(field.name);
    switch (field.place) {
        case Placement::positional:
            return name;
        case Placement::flag:
        case Placement::choice:
        case Placement::following:
            return name;
        case Placement::parts:
            return name + " { ... }";
        case Placement::loose_part:
            return name + " ...";
        case Placement::list:
            return name + " { count, ... }";
        case Placement::counted:
            return (field.entries > 0 ? "" : "count, ") + name + ", ...";
        case Placement::item:
            break;
    }
    return message(name, ' ', letter(field.type));
}

std::string explanation(const ItemInfo& item, std::size_t field) {
    const FieldInfo& info = item.fields[field];
    if (info.parts) return message(info.help, ": ", usage(info.parts->info()));
    return message(info.help, " (", values(item, field), ")");
}

/// Whether the field is a further value of a preceding field's word.
bool is_further_value(const ItemInfo& item, std::size_t field) {
    return item.fields[field].place == Placement::following && word_of(item, field) != field;
}

std::vector<ManualEntry> entries_of(const ItemInfo& item) {
    std::vector<ManualEntry> result;
    for (std::size_t i = 0; i < item.fields.size(); ++i) {
        if (is_further_value(item, i))
            result.back().help += "; " + explanation(item, i);
        else
            result.push_back({term(item, i), explanation(item, i)});
    }
    return result;
}

std::string text_entry(const ManualEntry& entry) {
    const std::string indent(term_width, ' ');
    std::string line = "  " + entry.term;
    if (line.size() + 2 > term_width)
        line += "\n" + indent;
    else
        line.resize(term_width, ' ');
    line += wrapped(entry.help, term_width) + "\n";
    if (!entry.example.empty())
        line += message(indent, "e.g. ", wrapped(entry.example, term_width + 2), "\n");
    return line;
}

/// The example as code below what stands before it.
std::string roff_example(std::string_view example) {
    return example.empty() ? "" : message(".br\n\\f(CR", roff(example), "\\fR\n");
}

std::string roff_entry(const ManualEntry& entry) {
    return message(".TP\n.B ", roff(entry.term), "\n", roff_lines(entry.help),
                   roff_example(entry.example));
}

std::string text_groups(std::span<const ItemGroup> groups) {
    std::string text;
    for (const ItemGroup& group : groups) {
        text += message(text.empty() ? "" : "\n", group.name, ": ", wrapped(group.help, 2), "\n");
        for (const ItemInfo* item : group.items) text += "\n" + manual(*item, group.block);
    }
    return text;
}

std::string roff_item(const ItemInfo& item, std::string_view block) {
    std::string text =
        message(".PP\n.B ", roff(usage(item, block)), "\n.br\n", roff_lines(item.help));
    if (!item.examples.empty()) text += roff_example(item.examples.front());
    if (!item.fields.empty())
        text += message(".RS\n", manual(entries_of(item), ManualForm::roff), ".RE\n");
    return text;
}

std::string roff_groups(std::span<const ItemGroup> groups) {
    std::string text;
    for (const ItemGroup& group : groups) {
        text += message(".SS ", roff(group.name), "\n", roff_lines(group.help));
        for (const ItemInfo* item : group.items) text += roff_item(*item, group.block);
    }
    return text;
}

Json json_value(const FieldValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* v = std::get_if<Vec2>(&value)) return {v->x, v->y};
    if (const auto* v = std::get_if<Vec3>(&value)) return {v->x, v->y, v->z};
    if (const auto* v = std::get_if<Vec4>(&value)) return {v->x, v->y, v->z, v->w};
    if (const auto* c = std::get_if<Colour>(&value))
        return {c->rgb.r, c->rgb.g, c->rgb.b, c->filter, c->transmit};
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (std::holds_alternative<std::monostate>(value)) return nullptr;
    return Json::array();
}

Json json_field(const ItemInfo& item, std::size_t index) {
    const FieldInfo& field = item.fields[index];
    Json json = {{"name", field.name},
                 {"place", name_of(field.place)},
                 {"type", name_of(field.type)},
                 {"default", json_value(item.default_value(index))},
                 {"optional", !field.unnamed() || field.may_be_left_out}};
    if (field.range.any_sign)
        json["any_sign"] = true;
    else if (std::isfinite(field.range.low))
        json[field.range.low_excluded ? "above" : "minimum"] = field.range.low;
    if (std::isfinite(field.range.high)) json["maximum"] = field.range.high;
    json["help"] = field.help;
    return json;
}

Json json_item(const ItemInfo& item, std::string_view block) {
    Json fields = Json::array();
    for (std::size_t i = 0; i < item.fields.size(); ++i) fields.push_back(json_field(item, i));
    return {{"name", item.name},
            {"usage", usage(item, block)},
            {"help", item.help},
            {"examples", item.examples},
            {"fields", fields}};
}

std::string json_groups(std::span<const ItemGroup> groups) {
    Json all = Json::array();
    for (const ItemGroup& group : groups) {
        Json items = Json::array();
        for (const ItemInfo* item : group.items) items.push_back(json_item(*item, group.block));
        all.push_back({{"name", group.name}, {"help", group.help}, {"items", items}});
    }
    return all.dump(2) + "\n";
}

}  // namespace

std::string usage(const ItemInfo& item, std::string_view block) {
    std::string text = block.empty() ? message(item.name, " {") : message(block, " { ", item.name);
    bool first = true;
    for (std::size_t i = 0; i < item.fields.size(); ++i) {
        const FieldInfo& field = item.fields[i];
        if (field.place == Placement::following) continue;
        const bool positional = field.unnamed();
        std::string piece = term(item, i);
        if (!positional || field.may_be_left_out)
            piece = message(positional && !first ? "[, " : "[", piece, "]");
        else if (!first)
            piece = ", " + piece;
        text += (piece.starts_with(',') || piece.starts_with("[,") ? "" : " ") + piece;
        first = false;
    }
    return text + " }";
}

std::size_t word_of(const ItemInfo& item, std::size_t field) {
    std::size_t word = field;
    while (word > 0 && item.fields[word].place == Placement::following) --word;
    return item.fields[word].place == Placement::list ? field : word;
}

std::string_view further_value(const ItemInfo& item, std::size_t field) {
    constexpr auto values = std::to_array<std::string_view>(
        {"", "the second value", "the third value", "the fourth value"});
    return values.at(field - word_of(item, field));
}

std::string term(const ItemInfo& item, std::size_t field) {
    std::string text = form(item.fields[field]);
    for (std::size_t i = field + 1; i < item.fields.size() && word_of(item, i) == field; ++i)
        text += message(item.fields[i].may_be_left_out ? "[, " : ", ", letter(item.fields[i].type),
                        item.fields[i].may_be_left_out ? "]" : "");
    return text;
}

std::string takes(const FieldInfo& field) {
    if (field.place == Placement::choice) return "on or off";
    return message(name_of(field.type), limits(field.range));
}

std::string values(const ItemInfo& item, std::size_t field) {
    const FieldInfo& info = item.fields[field];
    const std::string text = takes(info);
    const std::string initial = default_text(item, field);
    const bool required = info.unnamed() && !info.may_be_left_out;
    return required || initial.empty() ? text : message(text, ", default ", initial);
}

std::string manual(const ItemInfo& item, std::string_view block) {
    const std::string example =
        item.examples.empty() ? "" : message("  e.g. ", wrapped(item.examples.front(), 4), "\n");
    return message(wrapped(usage(item, block), 4), "\n  ", wrapped(item.help, 2), "\n", example,
                   manual(entries_of(item), ManualForm::text));
}

std::string manual(std::span<const ItemGroup> groups, ManualForm form) {
    switch (form) {
        case ManualForm::text:
            return text_groups(groups);
        case ManualForm::roff:
            return roff_groups(groups);
        case ManualForm::json:
            break;
    }
    return json_groups(groups);
}

std::string manual(std::span<const ManualEntry> list, ManualForm form) {
    if (form == ManualForm::json) {
        Json all = Json::array();
        for (const ManualEntry& entry : list) {
            all.push_back({{"term", entry.term}, {"help", entry.help}});
            if (!entry.example.empty()) all.back()["example"] = entry.example;
        }
        return all.dump(2) + "\n";
    }
    std::string text;
    for (const ManualEntry& entry : list)
        text += form == ManualForm::text ? text_entry(entry) : roff_entry(entry);
    return text;
}

std::string roff(std::string_view text) {
    std::string result;
    if (text.starts_with('.')) result = "\\&";
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if (c == '^')
            result += "\\(ha";
        else if (c == '~')
            result += "\\(ti";
        else if (c == '`')
            result += "\\(ga";
        else if (c == '\'')
            result += "\\(aq";
        else if (c == '"')
            result += "\\(dq";
        else if (c == '\n')
            result += ' ';
        else
            result += c;
    }
    return result;
}

std::string roff_lines(std::string_view text) {
    std::string lines = wrapped(roff(text), 0);
    for (std::size_t at = lines.find("\n."); at != std::string::npos; at = lines.find("\n.", at))
        lines.insert(at + 1, "\\&");
    return lines + "\n";
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
    std::string result;
    std::size_t column = indent;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(' '), text.size());
        if (column > indent && column + 1 + length > width) {
            result += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (column > indent) {
            result += ' ';
            ++column;
        }
        result += text.substr(0, length);
        column += length;
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return result;
}

}  // namespace candelabra
