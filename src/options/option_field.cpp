// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_field.h"

#include "options/option_store.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"
#include "vocabulary/manual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace candelabra {

namespace {

using Type = OptionField::Type;

/// A unit after a number. Ignores case.
struct Unit {
    char ending;
    double factor;
};
constexpr auto times = std::array{Unit{'s', 1}, Unit{'m', 60}, Unit{'h', 3600}};
constexpr auto sizes =
    std::array{Unit{'k', 0x1p10}, Unit{'m', 0x1p20}, Unit{'g', 0x1p30}, Unit{'t', 0x1p40}};

std::optional<double> with_unit(std::string_view text, std::span<const Unit> units) {
    for (const Unit& unit : units)
        if (!text.empty() && same_letters(text.substr(text.size() - 1), {&unit.ending, 1})) {
            const auto value = number(text.substr(0, text.size() - 1));
            return value ? std::optional(*value * unit.factor) : std::nullopt;
        }
    return number(text);
}

std::optional<double> number_of(const OptionField& field, std::string_view text) {
    if (field.type == Type::duration) return with_unit(text, times);
    if (field.type == Type::size) return with_unit(text, sizes);
    return number(text);
}

/// Returns what is stored, or monostate for a text that is no value.
OptionValue read_value(const OptionField& field, const Given& given) {
    if (field.type == Type::toggle) return given.on ? 1.0 : 0.0;
    const std::string text = given.value.value_or("");
    if (field.type == Type::text || field.type == Type::list) return text;
    if (field.type == Type::choice) {
        const auto found = std::ranges::find(field.names, text);
        if (found == field.names.end()) return {};
        if (field.kept_as_text) return text;
        return static_cast<double>(found - field.names.begin());
    }
    const auto value = number_of(field, text);
    if (!value || !field.range.contains(*value)) return {};
    if (field.type == Type::whole && std::floor(*value) != *value) return {};
    return *value * field.unit;
}

std::string list_of(std::span<const std::string_view> names) {
    std::string text;
    for (const std::string_view name : names)
        text += message(text.empty() ? "" : name == names.back() ? " or " : ", ", name);
    return text;
}

/// The number with "million" instead of six noughts.
std::string readable(double number) {
    constexpr double million = 1e6;
    const bool millions = number >= million && std::fmod(number, million) == 0;
    return millions ? message(number / million, " million") : message(number);
}

/// Writes a value that the field keeps.
std::string text_of(const OptionField& field, const OptionValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    const auto* number = std::get_if<double>(&value);
    if (!number) return {};
    if (field.type == Type::toggle) return *number > 0 ? "on" : "off";
    if (field.type == Type::choice)
        return std::string(field.names[static_cast<std::size_t>(*number)]);
    return message(*number / field.unit, field.type == Type::duration ? "s" : "");
}

}  // namespace

void store_field(const OptionField& field, Options& options, const Given& given,
                 Diagnostics& diagnostics) {
    const OptionValue value = read_value(field, given);
    if (std::holds_alternative<std::monostate>(value)) {
        const std::string got = given.value && !given.value->empty()
                                    ? message(", but it is `", printable(*given.value), "`")
                                    : "";
        const std::string meant =
            nearest(given.value.value_or(""), {field.names.begin(), field.names.end()});
        return refuse(given, diagnostics, message("must be ", takes(field), got),
                      meant.empty() ? "" : message("did you mean `", meant, "`?"));
    }
    field.set(options, value);
    if (field.then) field.then(options);
}

std::vector<std::string> changed_values(const OptionField& field, const Options& options) {
    const OptionValue value = field.get(options);
    if (value == field.get(Options())) return {};
    if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) return *texts;
    return {text_of(field, value)};
}

std::string_view type_name(OptionField::Type type) {
    switch (type) {
        case Type::none:
            return {};
        case Type::toggle:
            return "boolean";
        case Type::number:
            return "number";
        case Type::whole:
            return "integer";
        case Type::duration:
            return "duration";
        case Type::size:
            return "size";
        case Type::text:
            return "text";
        case Type::list:
            return "texts";
        case Type::choice:
            return "choice";
    }
    return {};
}

std::string takes(const OptionField& field) {
    const auto in_range = [&](FieldType type) {
        FieldInfo info{};
        info.place = Placement::item;
        info.type = type;
        info.range = field.range;
        // A bound that nobody meets is no help.
        if (info.range.high >= 1e9) info.range.high = std::numeric_limits<double>::infinity();
        return takes(info);
    };
    switch (field.type) {
        case Type::none:
            return {};
        case Type::toggle:
            return "on or off";
        case Type::number:
            return message("a ", in_range(FieldType::number));
        case Type::whole:
            return message("a ", in_range(FieldType::integer));
        case Type::duration:
            return message("a time", field.range.low_excluded ? " above 0" : "",
                           ": seconds, or a number with s, m or h");
        case Type::size:
            return "a size: bytes, or a number with K, M, G or T";
        case Type::text:
        case Type::list:
            return "a text";
        case Type::choice:
            return list_of(field.names);
    }
    return {};
}

std::string default_text(const OptionField& field) {
    const Options usual;
    const OptionValue value = field.get(usual);
    if (const auto* number = std::get_if<double>(&value);
        number && (field.type == Type::whole || field.type == Type::number))
        return readable(*number / field.unit);
    return text_of(field, value);
}

std::string values(const OptionField& field) {
    if (field.type == Type::toggle || field.type == Type::text || field.type == Type::list)
        return {};
    std::string text = takes(field);
    if (text.starts_with("a ")) text.erase(0, 2);
    const std::string usual = default_text(field);
    return usual.empty() ? text : message(text, ", default ", usual);
}

}  // namespace candelabra
