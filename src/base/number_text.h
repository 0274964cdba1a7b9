// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers from text, as std::from_chars reads them. Some systems' standard libraries do not have
// it for numbers with a fraction.
#pragma once

#include <charconv>
#include <concepts>

namespace candelabra {

/// Reads the longest number at `first` and rounds it to the nearest double or float. Returns its
/// end, and as std::from_chars whether there is a number and whether it is in the type's range.
std::from_chars_result number_from(const char* first, const char* last, double& value,
                                   std::chars_format = std::chars_format::general);
std::from_chars_result number_from(const char* first, const char* last, float& value);

template <std::integral Whole>
std::from_chars_result number_from(const char* first, const char* last, Whole& value) {
    return std::from_chars(first, last, value);
}

}  // namespace candelabra
