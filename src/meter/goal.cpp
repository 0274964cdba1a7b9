// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/goal.h"

#include "text/decimal.h"

#include <array>
#include <utility>

namespace candelabra {

namespace {

constexpr auto units =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"lux", "lx"}, {"nit", "cd/m2"}});
constexpr auto last_quantity = static_cast<int>(Quantity::daylight_factor);

/// The unit or the name that the word stands for; empty for other words.
std::string_view meant(std::string_view word) {
    for (const auto& [name, unit] : units)
        if (name == word) return unit;
    for (int i = 0; i <= last_quantity; ++i)
        if (const auto name = name_of(static_cast<Quantity>(i)); name == word) return name;
    return {};
}

}  // namespace

bool MeterGoal::counts(Quantity quantity) const {
    return what.empty() || what == unit_of(quantity) || what == name_of(quantity);
}

std::optional<MeterGoal> read_meter_goal(std::string_view text) {
    MeterGoal goal;
    if (const auto blank = text.find(' '); blank != text.npos) {
        goal.what = meant(text.substr(0, blank));
        if (goal.what.empty()) return std::nullopt;
        text.remove_prefix(blank + 1);
    }
    if (!text.ends_with('%')) return std::nullopt;
    text.remove_suffix(1);
    const auto number = finite_number(text);
    constexpr double least = 0.001, most = 100, per_cent = 100;
    if (!number || *number < least || *number > most) return std::nullopt;
    goal.error = *number / per_cent;
    return goal;
}

}  // namespace candelabra
