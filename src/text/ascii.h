// SPDX-License-Identifier: GPL-3.0-or-later
// Letters of ASCII only: their case, in options, file endings and names that were perhaps meant,
// and the words that they make. Other letters are as different as they look, and belong to no word.
#pragma once

#include <algorithm>
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

/// What names begin with.
constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// What names consist of.
constexpr bool in_name(char c) { return is_letter(c) || is_digit(c); }

/// Takes the part before the first of the signs off the text, and that sign; all of it when there
/// is none.
constexpr std::string_view take_until(std::string_view& text, std::string_view signs) {
    const std::size_t end = std::min(text.find_first_of(signs), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

/// Whether the text begins with that word, and no longer one.
constexpr bool begins_with_word(std::string_view text, std::string_view word) {
    return text.starts_with(word) && (text.size() == word.size() || !in_name(text[word.size()]));
}

/// Whether the text ends in that word, and in no longer one.
constexpr bool ends_in_word(std::string_view text, std::string_view word) {
    return text.ends_with(word) &&
           (text.size() == word.size() || !in_name(text[text.size() - word.size() - 1]));
}

/// Whether the texts are the same but for the case of letters.
inline bool same_letters(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) { return lower_case(x) == lower_case(y); });
}

}  // namespace candelabra
