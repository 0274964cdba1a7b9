// SPDX-License-Identifier: GPL-3.0-or-later
// ASCII letters only: case-insensitive comparison for options, file extensions and suggestions, and
// word boundaries. Other characters compare by their bytes and belong to no word.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace candelabra {

constexpr char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string lower_case(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = lower_case(c);
    return result;
}

/// Whether the character may begin a name.
constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_hex_digit(char c) {
    return is_digit(c) || (lower_case(c) >= 'a' && lower_case(c) <= 'f');
}
/// Whether the character may occur in a name.
constexpr bool in_name(char c) { return is_letter(c) || is_digit(c); }

/// Removes and returns the part of the text before the first of the separators, and removes that
/// separator. Returns all of the text if there is none.
constexpr std::string_view take_until(std::string_view& text, std::string_view signs) {
    const std::size_t end = std::min(text.find_first_of(signs), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

/// Whether the text begins with that word, rather than with a longer one.
constexpr bool begins_with_word(std::string_view text, std::string_view word) {
    return text.starts_with(word) && (text.size() == word.size() || !in_name(text[word.size()]));
}

/// Whether the text ends in that word, rather than in a longer one.
constexpr bool ends_in_word(std::string_view text, std::string_view word) {
    return text.ends_with(word) &&
           (text.size() == word.size() || !in_name(text[text.size() - word.size() - 1]));
}

/// Whether the texts are equal, ignoring ASCII case.
inline bool same_letters(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) { return lower_case(x) == lower_case(y); });
}

}  // namespace candelabra
