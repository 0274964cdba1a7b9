// SPDX-License-Identifier: GPL-3.0-or-later
// The value of an option that is no field of an item: where Options keeps it, its type, and its
// range. Storing, the value in force, help and JSON are derived from it by the functions below.
#pragma once

#include "options/options.h"
#include "vocabulary/item_info.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace candelabra {

struct Given;

/// A number (also of a switch or of an enumerator), a text, or several texts; monostate: unset.
using OptionValue = std::variant<std::monostate, double, std::string, std::vector<std::string>>;

struct OptionField {
    enum class Type {
        none,      ///< the option is no field
        toggle,    ///< on or off
        number,    ///< any number in the range
        whole,     ///< a whole number in the range, kept times the unit
        duration,  ///< seconds, or a number with s, m or h
        size,      ///< bytes, or a number with K, M, G or T
        text,      ///< any text
        list,      ///< a text; each one that is given is added
        choice,    ///< one of the names; its number is kept, or the name itself in a text
    };

    Type type = Type::none;
    OptionValue (*get)(const Options&) = nullptr;
    void (*set)(Options&, const OptionValue&) = nullptr;
    Range range = {};
    double unit = 1;  ///< what a value of 1 is kept as
    bool kept_as_text = false;
    std::span<const std::string_view> names = {};
    void (*then)(Options&) = nullptr;  ///< adapts what depends on the value; may be null

    explicit constexpr operator bool() const { return type != Type::none; }
};

namespace option_detail {

template <auto first, auto... rest>
auto& member_of(auto& object) {
    if constexpr (sizeof...(rest) == 0)
        return object.*first;
    else
        return member_of<rest...>(object.*first);
}

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class T>
OptionValue load(const T& from) {
    if constexpr (IsOptional<T>::value)
        return from ? load(*from) : OptionValue();
    else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
        return static_cast<double>(from);
    else
        return from;
}

template <class T>
void assign(T& to, const OptionValue& value) {
    if constexpr (IsOptional<T>::value) {
        typename T::value_type kept{};
        assign(kept, value);
        to = kept;
    } else if constexpr (std::is_same_v<T, bool>) {
        to = std::get<double>(value) > 0;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
        to = static_cast<T>(std::get<double>(value));
    } else if constexpr (std::is_same_v<T, std::string>) {
        to = std::get<std::string>(value);
    } else {
        to.push_back(std::get<std::string>(value));
    }
}

}  // namespace option_detail

/// The field that a member of Options, or a member of a member, keeps.
template <auto... members>
constexpr OptionField kept(OptionField::Type type, Range range = {}, double unit = 1) {
    using namespace option_detail;
    using Kept = std::remove_cvref_t<decltype(member_of<members...>(std::declval<Options&>()))>;
    OptionField field{type};
    field.get = [](const Options& options) { return load(member_of<members...>(options)); };
    field.set = [](Options& options, const OptionValue& value) {
        assign(member_of<members...>(options), value);
    };
    field.range = range;
    field.unit = unit;
    field.kept_as_text = std::is_same_v<Kept, std::string>;
    return field;
}

/// A field that takes one of the names. They are constants.
template <auto... members>
constexpr OptionField one_of(std::span<const std::string_view> names) {
    OptionField field = kept<members...>(OptionField::Type::choice);
    field.names = names;
    return field;
}

/// Stores the value of the option, or reports an error.
void store_field(const OptionField&, Options&, const Given&, Diagnostics&);

/// Returns the value in force as texts of the command line; empty if it is the usual one.
std::vector<std::string> changed_values(const OptionField&, const Options&);

/// The type of the value for programs: "boolean", "number", "integer", "duration", "size", "text",
/// "texts" or "choice".
std::string_view type_name(OptionField::Type);

/// Type and range of the value: "whole number from 1 to 65535".
std::string takes(const OptionField&);

/// The value without the option as a text: "25", "60s"; empty: there is none.
std::string default_text(const OptionField&);

/// Type, range and default of the value: "number above 0, default 25". Empty for texts and
/// switches.
std::string values(const OptionField&);

}  // namespace candelabra
