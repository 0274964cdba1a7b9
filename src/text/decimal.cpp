// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/decimal.h"

#include "base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

namespace candelabra {

bool underflows(std::string_view number) {
    const std::size_t e = std::min(number.find_first_of("eE"), number.size());
    const std::string_view digits = number.substr(0, e);
    const std::size_t first = digits.find_first_of("123456789");
    if (first == digits.npos) return true;
    const auto point = static_cast<long long>(std::min(digits.find('.'), digits.size()));
    const auto place = static_cast<long long>(first);
    const long long magnitude = place < point ? point - place - 1 : point - place;
    std::string_view power = number.substr(std::min(e + 1, number.size()));
    const bool negative = power.starts_with('-');
    if (power.starts_with('+') || negative) power.remove_prefix(1);
    int exponent = 0;
    const auto [end, failure] =
        std::from_chars(power.data(), power.data() + power.size(), exponent);
    if (failure == std::errc::result_out_of_range) return negative;
    return magnitude + (negative ? -exponent : exponent) < 0;
}

std::optional<double> finite_number(std::string_view text) {
    double number = 0;
    const auto [end, failed] = number_from(text.data(), text.data() + text.size(), number);
    // from_chars also reads "inf" and "nan".
    const bool whole = failed == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace candelabra
