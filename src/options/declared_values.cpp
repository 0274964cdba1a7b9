// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/declared_values.h"

#include "options/option_store.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/trimmed.h"
#include "vocabulary/words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view rgb = "rgb";

bool is_identifier(std::string_view name) {
    return !name.empty() && is_letter(name[0]) && std::ranges::all_of(name, in_name);
}

/// Reads `<1, 2, 3>` with two to five numbers.
std::optional<Numbers> vector_of(std::string_view text) {
    text = trimmed(text, " ");
    if (!text.starts_with('<') || !text.ends_with('>')) return std::nullopt;
    text = text.substr(1, text.size() - 2);
    Numbers numbers;
    numbers.count = 0;
    for (bool more = true; more;) {
        more = text.find(',') != text.npos;
        const auto value = number(trimmed(take_until(text, ","), " "));
        if (!value || numbers.count == 5) return std::nullopt;
        numbers.at[static_cast<std::size_t>(numbers.count++)] = *value;
    }
    return numbers.count > 1 ? std::optional(numbers) : std::nullopt;
}

/// Returns the colour whose red, green and blue the vector has.
std::optional<Numbers> colour_of(const std::optional<Numbers>& vector) {
    if (!vector || vector->count != 3) return std::nullopt;
    return Numbers::colour({rgb_of(vector->vec3()), 0, 0});
}

std::optional<Numbers> vector_of(const Json& json) {
    if (!json.is_array() || json.size() < 2 || json.size() > 5) return std::nullopt;
    Numbers numbers;
    numbers.count = static_cast<int>(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (!json[i].is_number()) return std::nullopt;
        numbers.at[i] = json[i].get<double>();
    }
    return numbers;
}

std::optional<DeclaredValue> value_of(const Json& json) {
    if (json.is_boolean()) return json.get<bool>() ? 1.0 : 0.0;
    if (json.is_number()) return json.get<double>();
    if (json.is_string()) return json.get<std::string>();
    const bool coloured = json.is_object() && json.size() == 1 && json.contains(rgb);
    const auto numbers = coloured ? colour_of(vector_of(json.front())) : vector_of(json);
    if (!numbers) return std::nullopt;
    return *numbers;
}

}  // namespace

std::optional<DeclaredValue> declared_value(std::string_view text) {
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        return std::string(text.substr(1, text.size() - 2));
    if (const auto value = number(text)) return *value;
    if (const auto value = truth(text)) return *value ? 1.0 : 0.0;
    const auto numbers =
        text.starts_with(rgb) ? colour_of(vector_of(text.substr(rgb.size()))) : vector_of(text);
    if (!numbers) return std::nullopt;
    return *numbers;
}

std::string text_of(const DeclaredValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return message('"', *text, '"');
    if (const auto* single = std::get_if<double>(&value)) return message(*single);
    const Numbers& numbers = std::get<Numbers>(value);
    std::string text;
    const int count = numbers.is_colour() ? 3 : numbers.count;
    for (int i = 0; i < count; ++i)
        text += message(i > 0 ? ", " : "", numbers.at[static_cast<std::size_t>(i)]);
    return message(numbers.is_colour() ? "rgb <" : "<", text, '>');
}

std::string problem_with_name(std::string_view name) {
    if (!is_identifier(name)) return "needs a name and a value";
    const Names names;
    if (names.find(std::string(name)) != no_name)
        return message("`", name, "` is a word of the language and cannot be declared");
    return {};
}

std::optional<std::vector<Declaration>> preset(std::string_view json, std::string& problem) {
    const Json all = Json::parse(json, nullptr, false);
    if (!all.is_object()) {
        problem = "the file is no JSON object of names and values";
        return std::nullopt;
    }
    std::vector<Declaration> set;
    for (const auto& [name, each] : all.items()) {
        const auto value = value_of(each);
        problem = problem_with_name(name);
        if (!value || !problem.empty()) {
            if (problem.empty() || !value)
                problem = message("`", printable(name),
                                  "` must be a number, true or false, a string, a vector [1, 2, "
                                  "3] or a colour {\"rgb\": [1, 0.5, 0]}");
            return std::nullopt;
        }
        set.emplace_back(name, *value);
    }
    return set;
}

}  // namespace candelabra
