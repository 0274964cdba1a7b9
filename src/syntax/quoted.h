// SPDX-License-Identifier: GPL-3.0-or-later
// Strings as literals of the language.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace candelabra {

inline std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        constexpr std::string_view special = "\a\b\f\n\r\t\v\"\\";
        constexpr std::string_view letters = "abfnrtv\"\\";
        const std::size_t i = special.find(c);
        if (i != std::string_view::npos)
            (result += '\\') += letters[i];
        else
            result += c;
    }
    return result + '"';
}

}  // namespace candelabra
