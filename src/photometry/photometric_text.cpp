// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/photometric_text.h"

#include "text/decimal.h"
#include "text/trimmed.h"
#include "text/utf8.h"

namespace candelabra {

namespace {

constexpr std::string_view separators = " \t,;\v\f";

bool is_utf8(std::string_view bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const Character character = character_at(bytes, at);
        if (!character.valid) return false;
        at += character.length;
    }
    return true;
}

/// Latin-1 as UTF-8: characters from 128 on have two bytes.
std::string from_latin(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x80) {
            text += c;
        } else {
            text += static_cast<char>(0xc0 | code >> 6);
            text += static_cast<char>(0x80 | (code & 0x3f));
        }
    }
    return text;
}

}  // namespace

std::vector<std::string> lines_of(std::string_view bytes, bool& latin) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (bytes.starts_with(mark)) bytes.remove_prefix(mark.size());
    latin = !is_utf8(bytes);
    std::vector<std::string> lines;
    while (!bytes.empty()) {
        const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
        const std::string_view line = bytes.substr(0, end);
        lines.push_back(latin ? from_latin(line) : std::string(line));
        const bool both = bytes.substr(end).starts_with("\r\n");
        bytes.remove_prefix(std::min(bytes.size(), end + (both ? 2 : 1)));
    }
    return lines;
}

std::string_view trimmed(std::string_view text) { return trimmed(text, " \t\v\f"); }

std::optional<double> number_of(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    return finite_number(text);
}

std::optional<double> NumberStream::next() {
    stray_.clear();
    for (; line_ < lines_.size(); ++line_, column_ = 0) {
        const std::string_view line = lines_[line_];
        const std::size_t first = line.find_first_not_of(separators, column_);
        if (first == line.npos) continue;
        const std::size_t end = std::min(line.find_first_of(separators, first), line.size());
        place_ = line_;
        column_ = end;
        const std::string_view word = line.substr(first, end - first);
        const std::optional<double> number = number_of(word);
        if (!number) stray_ = word;
        return number;
    }
    if (!lines_.empty()) place_ = lines_.size() - 1;
    return std::nullopt;
}

}  // namespace candelabra
