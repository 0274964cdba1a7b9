// SPDX-License-Identifier: GPL-3.0-or-later
// The case of letters, of ASCII only: of options, file endings and names that were perhaps meant.
// Other letters are as different as they look.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

constexpr char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string lower_case(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = lower_case(c);
    return result;
}

/// Whether the texts are the same but for the case of letters.
inline bool same_letters(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) { return lower_case(x) == lower_case(y); });
}
