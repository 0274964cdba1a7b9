// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/protocol.h"

#include "text/message.h"
#include "text/utf8.h"

#include <algorithm>
#include <cctype>

namespace candelabra {

namespace {

constexpr std::string_view scheme = "file://";
constexpr std::string_view hexadecimal = "0123456789ABCDEF";

/// Number of UTF-16 code units of the character.
int units(const Character& character) { return character.code > 0xFFFF ? 2 : 1; }

int digit(char c) {
    const std::size_t at =
        hexadecimal.find(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
    return at == hexadecimal.npos ? -1 : static_cast<int>(at);
}

std::int64_t number(const Json& object, const char* name) {
    const auto found = object.find(name);
    return found != object.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
}

/// Number of UTF-16 code units of a part of a line.
int column(std::string_view line) {
    int units_before = 0;
    for (std::size_t at = 0; at < line.size();) {
        const Character character = character_at(line, at);
        units_before += units(character);
        at += character.length;
    }
    return units_before;
}

/// Returns the beginning of the line after the one at this offset; npos if there is none. As in the
/// protocol, lines end in CR LF, LF or CR.
std::size_t next_line(std::string_view text, std::size_t at) {
    const std::size_t end = text.find_first_of("\r\n", at);
    if (end == text.npos) return end;
    return end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
}

}  // namespace

std::string path_of(std::string_view uri) {
    if (!uri.starts_with(scheme)) return std::string(uri);
    uri.remove_prefix(scheme.size());
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool coded =
            uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
        path += coded ? static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
        if (coded) i += 2;
    }
    return path;
}

std::string uri_of(std::string_view path) {
    std::string uri(scheme);
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || std::string_view("/-_.~").find(c) != std::string_view::npos)
            uri += c;
        else
            uri += message('%', hexadecimal[byte / 16], hexadecimal[byte % 16]);
    }
    return uri;
}

bool nests_deeper(std::string_view json, int most) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (quoted && c == '\\') ++i;
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (depth > most) return true;
    }
    return false;
}

std::uint32_t offset_of(std::string_view text, const Json& position) {
    std::size_t at = 0;
    for (std::int64_t line = number(position, "line"); line > 0; --line) {
        at = next_line(text, at);
        if (at == text.npos) return static_cast<std::uint32_t>(text.size());
    }
    for (std::int64_t left = number(position, "character");
         left > 0 && at < text.size() && text[at] != '\n' && text[at] != '\r';) {
        const Character character = character_at(text, at);
        left -= units(character);
        at += character.length;
    }
    return static_cast<std::uint32_t>(at);
}

Json position_of(std::string_view text, std::uint32_t offset) {
    return LineTable(text).position_of(offset);
}

Json range_of(std::string_view text, Part part) { return LineTable(text).range_of(part); }

LineTable::LineTable(std::string_view text) : text_(text), starts_{0} {
    for (std::size_t at = next_line(text, 0); at != text.npos; at = next_line(text, at))
        starts_.push_back(static_cast<std::uint32_t>(at));
}

std::size_t LineTable::line_of(std::uint32_t offset) const {
    const std::size_t end = std::min<std::size_t>(offset, text_.size());
    return static_cast<std::size_t>(std::ranges::upper_bound(starts_, end) - starts_.begin()) - 1;
}

Json LineTable::position_of(std::uint32_t offset) const {
    const std::size_t end = std::min<std::size_t>(offset, text_.size());
    const std::size_t line = line_of(offset);
    const std::size_t start = starts_[line];
    return {{"line", line}, {"character", column(text_.substr(start, end - start))}};
}

Json LineTable::range_of(Part part) const {
    return {{"start", position_of(part.first)}, {"end", position_of(part.last)}};
}

void TextWalk::go_to(std::uint32_t offset) {
    const std::size_t end = std::min<std::size_t>(offset, text_.size());
    while (next_ <= end) {
        at_ = next_;
        next_ = next_line(text_, at_);
        column_ = 0;
        ++line_;
    }
    if (end > at_) column_ += candelabra::column(text_.substr(at_, end - at_));
    at_ = std::max(at_, end);
}

}  // namespace candelabra
