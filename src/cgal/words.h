// SPDX-License-Identifier: GPL-3.0-or-later
// Words and numbers of text, for the readers of files.
#pragma once

#include <algorithm>
#include <charconv>
#include <string_view>

namespace candelabra {

namespace polyhedra {

inline constexpr std::string_view blanks = " \t\r\n";

/// Takes a word from the front; empty at the end.
inline std::string_view next_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    return word;
}

/// Leaves out what is left of a line.
inline void skip_line(std::string_view& text) {
    text.remove_prefix(std::min(text.find('\n'), text.size()));
}

/// Whether the word is a number.
template <class Number>
bool read_number(std::string_view word, Number& value) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    return failure == std::errc() && end == word.data() + word.size();
}

}  // namespace polyhedra

}  // namespace candelabra
