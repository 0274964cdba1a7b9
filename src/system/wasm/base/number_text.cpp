// SPDX-License-Identifier: GPL-3.0-or-later
// By strtod(), which rounds correctly here. What it reads beyond std::from_chars is kept from it.
#include "base/number_text.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace candelabra {

namespace {

bool is_digit_of(char c, bool hex) {
    const char low = static_cast<char>(c | 0x20);
    return (c >= '0' && c <= '9') || (hex && low >= 'a' && low <= 'f');
}

/// The end of the digits at `at`.
const char* behind_digits(const char* at, const char* last, bool hex) {
    while (at != last && is_digit_of(*at, hex)) ++at;
    return at;
}

/// The end of the number at `at`, which has no sign; `at` itself if there is none.
const char* end_of_number(const char* at, const char* last, bool hex) {
    const char* end = behind_digits(at, last, hex);
    bool digits = end != at;
    if (end != last && *end == '.') {
        const char* const behind = behind_digits(end + 1, last, hex);
        digits = digits || behind != end + 1;
        if (digits) end = behind;
    }
    if (!digits) return at;
    if (end == last || (*end | 0x20) != (hex ? 'p' : 'e')) return end;
    const char* power = end + 1;
    if (power != last && (*power == '+' || *power == '-')) ++power;
    const char* const behind = behind_digits(power, last, false);
    return behind != power ? behind : end;
}

/// The end of "inf", "infinity", "nan" or "nan(...)" in any case; `at` itself if there is none.
const char* end_of_word(const char* at, const char* last) {
    const auto begins = [&](std::string_view word) {
        if (static_cast<std::size_t>(last - at) < word.size()) return false;
        for (std::size_t i = 0; i < word.size(); ++i)
            if ((at[i] | 0x20) != word[i]) return false;
        return true;
    };
    for (const std::string_view word : {"infinity", "inf", "nan"})
        if (begins(word)) return at + word.size();
    return at;
}

template <class Number>
std::from_chars_result read(const char* first, const char* last, Number& value, bool hex,
                            Number (*convert)(const char*, char**)) {
    const char* const digits = first + (first != last && *first == '-');
    const char* end = end_of_number(digits, last, hex);
    const bool number = end != digits;
    if (!number) end = end_of_word(digits, last);
    if (end == digits) return {first, std::errc::invalid_argument};
    std::string text(first, digits);
    if (hex && number) text += "0x";
    text.append(digits, end);
    const Number found = convert(text.c_str(), nullptr);
    const std::string_view all(digits, static_cast<std::size_t>(end - digits));
    const bool zero = all.substr(0, all.find_first_of(hex ? "pP" : "eE"))
                          .find_first_of(hex ? "123456789abcdefABCDEF" : "123456789") == all.npos;
    if (number && (std::isinf(found) || (found == 0 && !zero)))
        return {end, std::errc::result_out_of_range};
    value = found;
    return {end, {}};
}

}  // namespace

std::from_chars_result number_from(const char* first, const char* last, double& value,
                                   std::chars_format format) {
    return read<double>(first, last, value, format == std::chars_format::hex, std::strtod);
}

std::from_chars_result number_from(const char* first, const char* last, float& value) {
    return read<float>(first, last, value, false, std::strtof);
}

}  // namespace candelabra
