// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Iterates over UTF-8 characters in arbitrary bytes. A byte that is not part of a well-formed
// sequence is a character of its own, so every text can be traversed and counted.

#include <cstddef>
#include <string_view>

namespace candelabra {

struct Character {
    char32_t code = 0;
    std::size_t length = 1;  ///< in bytes
    bool valid = false;
};

/// Returns the character at a byte offset. Precondition: the offset is inside the text.
Character character_at(std::string_view text, std::size_t offset);

std::size_t character_count(std::string_view text);

}  // namespace candelabra
