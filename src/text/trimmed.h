// SPDX-License-Identifier: GPL-3.0-or-later
// Text without the blanks around it. Each format has its own set of blanks.
#pragma once

#include <algorithm>
#include <string_view>

namespace candelabra {

/// Returns the part of the text between its first and its last character that is no blank; empty
/// if there is none.
constexpr std::string_view trimmed(std::string_view text, std::string_view blanks) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

}  // namespace candelabra
