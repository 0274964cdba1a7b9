// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/escapes.h"

#include <charconv>
#include <system_error>

namespace candelabra {

namespace {

/// The character that `\` and this letter stand for, or 0.
char escape(char letter) {
    constexpr std::string_view letters = "abfnrtv'\"\\";
    constexpr std::string_view meanings = "\a\b\f\n\r\t\v'\"\\";
    const std::size_t i = letters.find(letter);
    return i == std::string_view::npos ? '\0' : meanings[i];
}

/// Reads a number of four hexadecimal digits. False if the text is not one.
bool read_hex(std::string_view digits, unsigned& code) {
    const auto [end, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    return problem == std::errc() && digits.size() == 4 && end == digits.data() + 4;
}

void append_utf8(std::string& text, unsigned code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xC0 | code >> 6);
        text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
        text += static_cast<char>(0xE0 | code >> 12);
        text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
        text += static_cast<char>(0x80 | (code & 0x3F));
    }
}

}  // namespace

std::string unescaped(std::string_view raw, SourceId source, std::uint32_t offset,
                      Diagnostics& diagnostics) {
    std::string result;
    result.reserve(raw.size());
    for (std::size_t i = 0; i < raw.size(); ++i) {
        unsigned code = 0;
        if (raw[i] == '\r') {
            result += '\n';
            if (i + 1 < raw.size() && raw[i + 1] == '\n') ++i;
        } else if (raw[i] != '\\' || i + 1 == raw.size()) {
            result += raw[i];
        } else if (const char meaning = escape(raw[i + 1])) {
            result += meaning;
            ++i;
        } else if (raw[i + 1] == 'u' && read_hex(raw.substr(i + 2, 4), code)) {
            append_utf8(result, code);
            i += 5;
        } else {
            const auto place = offset + static_cast<std::uint32_t>(i);
            diagnostics.add(
                error(Fault::syntax, {source, place, place + 2}, "a string has no such escape")
                    .with_help("known are \\a \\b \\f \\n \\r \\t \\v \\' \\\" \\\\ and \\uXXXX; a "
                               "backslash itself is \\\\"));
            result += raw[i];
        }
    }
    return result;
}

}  // namespace candelabra
