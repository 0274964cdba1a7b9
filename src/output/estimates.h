// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates with their 95 % intervals as cells of tables, as JSON and as text.
#pragma once

#include "meter/interval.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace candelabra {

/// The value with as many digits as an estimate has, and room.
double rounded(double value, int digits = 6);

std::string cell(double value);
/// A text as a cell of CSV, in quotes if necessary.
std::string csv_cell(std::string_view text);

/// The text with blanks before it, in a column of that width.
std::string padded(const std::string& text, std::size_t width);

/// An object with `value` and `error`.
nlohmann::json value_json(const MeterValue&);

/// The value with its interval, both to the digits that the interval leaves: "12.3 +- 0.14".
std::string shown(const MeterValue&);

}  // namespace candelabra
