// SPDX-License-Identifier: GPL-3.0-or-later
// Words and numbers of text, for the readers of files.
#pragma once

#include "base/number_text.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace candelabra {

namespace polyhedra {

inline constexpr std::string_view blanks = " \t\r\n";

/// Removes and returns the first word; empty at the end.
inline std::string_view next_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    return word;
}

/// Removes the rest of a line.
inline void skip_line(std::string_view& text) {
    text.remove_prefix(std::min(text.find('\n'), text.size()));
}

/// Parses the word; returns whether all of it is a number.
template <class Number>
bool read_number(std::string_view word, Number& value) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, failure] = number_from(word.data(), word.data() + word.size(), value);
    return failure == std::errc() && end == word.data() + word.size();
}

}  // namespace polyhedra

}  // namespace candelabra
