// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/estimates.h"

#include "base/number_text.h"
#include "text/message.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace candelabra {

double rounded(double value, int digits) {
    std::array<char, 40> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::scientific, digits - 1);
    double result = value;
    number_from(text.data(), end.ptr, result);
    return result;
}

std::string cell(double value) { return message(rounded(value)); }

std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

std::string padded(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

nlohmann::json value_json(const MeterValue& value) {
    return {{"value", rounded(value.value)}, {"error", rounded(value.error)}};
}

std::string shown(const MeterValue& value) {
    constexpr int most_digits = 4, digits_of_error = 2;
    // What is only due to rounding is no error of an estimate.
    constexpr double rounding = 1e-9;
    const bool exact = value.error <= rounding * std::abs(value.value);
    return message(rounded(value.value, most_digits), " +- ",
                   rounded(exact ? 0 : value.error, digits_of_error));
}

}  // namespace candelabra
