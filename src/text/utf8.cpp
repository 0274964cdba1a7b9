// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/utf8.h"

#include <cassert>

namespace candelabra {

namespace {

struct Lead {
    std::size_t length;
    char32_t bits;
    char32_t smallest;
};

Lead lead(unsigned char byte) {
    if (byte < 0x80) return {1, byte, 0};
    if ((byte & 0xE0) == 0xC0) return {2, byte & 0x1Fu, 0x80};
    if ((byte & 0xF0) == 0xE0) return {3, byte & 0x0Fu, 0x800};
    if ((byte & 0xF8) == 0xF0) return {4, byte & 0x07u, 0x10000};
    return {0, 0, 0};
}

}  // namespace

Character character_at(std::string_view text, std::size_t offset) {
    assert(offset < text.size());
    const auto byte = static_cast<unsigned char>(text[offset]);
    const Character broken{byte, 1, false};
    const Lead start = lead(byte);
    if (start.length == 0 || start.length > text.size() - offset) return broken;
    char32_t code = start.bits;
    for (std::size_t i = 1; i < start.length; ++i) {
        const auto next = static_cast<unsigned char>(text[offset + i]);
        if ((next & 0xC0) != 0x80) return broken;
        code = code << 6 | (next & 0x3Fu);
    }
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < start.smallest || surrogate || code > 0x10FFFF) return broken;
    return {code, start.length, true};
}

std::size_t character_count(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); at += character_at(text, at).length) ++count;
    return count;
}

}  // namespace candelabra
