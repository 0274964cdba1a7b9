// SPDX-License-Identifier: GPL-3.0-or-later
// The text of photometric files: lines in UTF-8, and numbers in a stream of lines.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Returns the lines of a file without their ends (CR, LF or both), each in UTF-8. Bytes that are
/// not UTF-8 are taken as Latin-1; then `latin` becomes true. A byte order mark is left out.
std::vector<std::string> lines_of(std::string_view bytes, bool& latin);

/// Returns the text without blanks at its ends.
std::string_view trimmed(std::string_view);

/// Returns a number that fills the whole text, blanks around it excepted; nothing for others, for
/// NaN and infinity.
std::optional<double> number_of(std::string_view text);

/// Takes numbers one after the other out of lines, however they are divided into lines. They are
/// separated by blanks, tabs, commas and semicolons.
class NumberStream {
public:
    /// Begins at a line, counted from 0. The lines must outlive the stream.
    NumberStream(const std::vector<std::string>& lines, std::size_t line)
        : lines_(lines), line_(line) {}

    /// Returns the next number; nothing at the end, or at a text that is no number: see problem().
    std::optional<double> next();

    /// Line of the last number or of the text that is none, from 1.
    std::size_t line() const { return place_ + 1; }
    /// The text that is no number; empty at the end of the lines.
    const std::string& stray() const { return stray_; }

private:
    const std::vector<std::string>& lines_;
    std::size_t line_, column_ = 0;
    std::size_t place_ = 0;
    std::string stray_;
};

}  // namespace candelabra
