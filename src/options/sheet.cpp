// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/sheet.h"

#include "options/declared_values.h"
#include "options/option_store.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"

#include <cmath>

namespace candelabra {

namespace {

constexpr int most_along_a_side = 100;
constexpr std::string_view clock_name = "clock";

std::optional<int> side(std::string_view text) {
    const auto value = number(text);
    if (!value || *value < 1 || *value > most_along_a_side || *value != std::floor(*value))
        return std::nullopt;
    return static_cast<int>(*value);
}

/// Returns as many values as places, at even distances.
std::vector<double> spread(double first, double last, int places) {
    std::vector<double> values;
    for (int i = 0; i < places; ++i)
        values.push_back(places == 1 ? first : first + (last - first) * i / (places - 1));
    return values;
}

/// Reads `1..12` or `1,2.5,4`; nothing for other texts.
std::optional<std::vector<double>> values_of(std::string_view text, int places) {
    if (const std::size_t dots = text.find(".."); dots != text.npos) {
        const auto first = number(text.substr(0, dots)), last = number(text.substr(dots + 2));
        if (!first || !last || !std::isfinite(*last - *first)) return std::nullopt;
        return spread(*first, *last, places);
    }
    std::vector<double> values;
    for (bool more = true; more;) {
        more = text.find(',') != text.npos;
        const auto value = number(take_until(text, ","));
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

/// Reads `Seed=1..12` into the sheet; says the problem, if there is one.
std::string read_name(std::string_view text, int places, Sheet& sheet) {
    const std::string_view whole = text;
    if (text.find('=') == text.npos)
        return message("`", printable(whole), "` needs a name and values, such as Seed=1..12");
    const std::string name(take_until(text, "="));
    if (name != clock_name)
        if (const std::string problem = problem_with_name(name); !problem.empty())
            return message("`", printable(whole), "`: ", problem);
    const auto values = values_of(text, places);
    if (!values)
        return message("`", printable(whole),
                       "` needs a range such as 1..12, or numbers such as 1,3,9");
    if (values->size() > static_cast<std::size_t>(places))
        return message("`", printable(name), "` has ", values->size(), " values, and there are ",
                       places, " places for them");
    for (const Sheet::Name& other : sheet.names)
        if (other.name == name) return message("`", printable(name), "` is given twice");
    sheet.names.push_back({name, *values});
    return {};
}

}  // namespace

int Sheet::pictures() const {
    std::size_t count = 1;
    for (const Name& each : names) count *= each.values.size();
    return static_cast<int>(count);
}

int Sheet::in_a_row() const {
    return names.size() > 1 ? static_cast<int>(names[0].values.size()) : columns;
}

std::vector<Declaration> Sheet::values_in(int picture) const {
    if (names.size() == 1)
        return {{names[0].name, names[0].values[static_cast<std::size_t>(picture)]}};
    return {{names[0].name, names[0].values[static_cast<std::size_t>(column_of(picture))]},
            {names[1].name, names[1].values[static_cast<std::size_t>(row_of(picture))]}};
}

std::optional<Sheet> sheet_of(std::string_view text, std::string& problem) {
    Sheet sheet;
    std::vector<std::string_view> words;
    while (!text.empty())
        if (const std::string_view word = take_until(text, " "); !word.empty())
            words.push_back(word);
    std::string_view size = words.empty() ? std::string_view() : words[0];
    const auto columns = side(take_until(size, "x")), rows = side(size);
    problem.clear();
    if (!columns || !rows)
        problem = message("the size of the sheet is two whole numbers from 1 to ",
                          most_along_a_side, ", columns and rows, such as 4x3");
    else if (words.size() < 2)
        problem = "the sheet needs a name whose values differ";
    else if (words.size() > 3)
        problem = "the pictures of a sheet differ in one name or in two";
    if (!problem.empty()) return std::nullopt;
    sheet.columns = *columns;
    sheet.rows = *rows;
    for (std::size_t i = 1; i < words.size() && problem.empty(); ++i) {
        const int places = words.size() == 2 ? sheet.columns * sheet.rows
                           : i == 1          ? sheet.columns
                                             : sheet.rows;
        problem = read_name(words[i], places, sheet);
    }
    return problem.empty() ? std::optional(sheet) : std::nullopt;
}

Options with_values(Options options, const std::vector<Declaration>& values) {
    for (const auto& [name, value] : values) {
        if (name == clock_name) {
            options.facts.clock = std::get<double>(value);
            options.facts.clock_given = true;
        } else {
            options.declares.emplace_back(name, value);
        }
    }
    return options;
}

}  // namespace candelabra
