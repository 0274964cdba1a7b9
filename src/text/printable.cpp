// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/printable.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

struct CodeRange {
    char32_t first;
    char32_t last;
};

// Characters that are invisible or affect their neighbours: directional marks and overrides,
// zero-width characters, line and paragraph separators, and the upper control characters.
constexpr auto hidden = std::array{
    CodeRange{0x80, 0x9F},       CodeRange{0x61C, 0x61C},   CodeRange{0x200B, 0x200F},
    CodeRange{0x2028, 0x202E},   CodeRange{0x2060, 0x206F}, CodeRange{0xFEFF, 0xFEFF},
    CodeRange{0xE0000, 0xE007F},
};

constexpr std::string_view replacement = "\xEF\xBF\xBD";        // U+FFFD
constexpr std::string_view picture_of_delete = "\xE2\x90\xA1";  // U+2421

bool is_hidden(char32_t code) {
    return std::any_of(hidden.begin(), hidden.end(), [code](const CodeRange& range) {
        return code >= range.first && code <= range.last;
    });
}

}  // namespace

std::string harmless_character(std::string_view text, std::size_t offset, Character character) {
    if (!character.valid || is_hidden(character.code)) return std::string(replacement);
    if (character.code == 0x7F) return std::string(picture_of_delete);
    if (character.code < 0x20) {
        // The symbols for control characters are in the same order, from U+2400 on.
        return {'\xE2', '\x90', static_cast<char>(0x80 + character.code)};
    }
    return std::string(text.substr(offset, character.length));
}

std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text, at);
        shown += harmless_character(text, at, character);
        at += character.length;
    }
    return shown;
}

}  // namespace candelabra
