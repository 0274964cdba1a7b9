// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// message("`", word, "` needs ", n, " numbers"): concatenates typed parts, for diagnostics and
// other texts for users. Strings are appended as they are, integers in decimal, and floating-point
// numbers with the fewest digits that read back as the same number. Independent of the locale.
// Booleans and enumerators do not compile, as they have no text of their own.

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace candelabra {

inline void append_part(std::string& text, std::string_view part) { text += part; }

template <std::same_as<char> T>
void append_part(std::string& text, T part) {
    text += part;
}

template <std::integral T>
requires(!std::same_as<T, bool> && !std::same_as<T, char>) void append_part(std::string& text,
                                                                            T part) {
    std::array<char, 24> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), part).ptr;
    text.append(buffer.data(), end);
}

/// Numbers of everyday magnitude are written without an exponent, and zero without a sign.
template <std::floating_point T>
void append_part(std::string& text, T part) {
    const T size = std::abs(part);
    const bool plain = size == 0 || (size >= T(1e-4) && size < T(1e15));
    std::array<char, 48> buffer;
    const auto begin = buffer.data();
    const auto end = begin + buffer.size();
    const auto written =
        plain ? std::to_chars(begin, end, size == 0 ? T(0) : part, std::chars_format::fixed)
              : std::to_chars(begin, end, part, std::chars_format::scientific);
    text.append(begin, written.ptr);
}

template <typename... Parts>
std::string message(const Parts&... parts) {
    std::string text;
    (append_part(text, parts), ...);
    return text;
}

}  // namespace candelabra
