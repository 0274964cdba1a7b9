// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/shell_word.h"

#include <algorithm>
#include <cctype>

namespace candelabra {

std::string shell_quoted(std::string_view text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string shell_word(std::string_view text) {
    const auto plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) ||
               std::string_view("/._-+,=@:").find(c) != std::string_view::npos;
    };
    return !text.empty() && std::ranges::all_of(text, plain) ? std::string(text)
                                                             : shell_quoted(text);
}

}  // namespace candelabra
