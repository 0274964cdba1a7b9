// SPDX-License-Identifier: GPL-3.0-or-later
// Conversions between the Language Server Protocol and this program: files are URIs, positions are
// lines and UTF-16 code units from 0. A position that does not exist becomes the nearest existing
// one; a position between the halves of a surrogate pair is after it.
#pragma once

#include "editor/edited_file.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

using Json = nlohmann::json;

/// Converts `file:///a%20b.pov` to `/a b.pov`; other URIs are returned unchanged.
std::string path_of(std::string_view uri);
std::string uri_of(std::string_view path);

/// Whether the brackets of a JSON text nest more deeply than `most`; called before parsing. The
/// depth may be miscounted in invalid JSON.
bool nests_deeper(std::string_view json, int most);

std::uint32_t offset_of(std::string_view text, const Json& position);
Json position_of(std::string_view text, std::uint32_t offset);
Json range_of(std::string_view text, Part);

/// The line starts of a text, for converting many ranges without counting lines each time. The text
/// must outlive the table.
class LineTable {
public:
    explicit LineTable(std::string_view text);
    /// Returns the line number, from 0.
    std::size_t line_of(std::uint32_t offset) const;
    Json position_of(std::uint32_t offset) const;
    Json range_of(Part) const;

private:
    std::string_view text_;
    std::vector<std::uint32_t> starts_;
};

/// Computes lines and columns of many places in source order in one pass over the text, even if it
/// is a single line. The text must outlive the object.
class TextWalk {
public:
    explicit TextWalk(std::string_view text) : text_(text) {}

    /// Advances to an offset, which must not be before the last one.
    void go_to(std::uint32_t offset);
    int line() const { return line_; }
    int column() const { return column_; }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t next_ = 0;  ///< beginning of the next line
    int line_ = -1;
    int column_ = 0;
};

}  // namespace candelabra
