// SPDX-License-Identifier: GPL-3.0-or-later
// The values of the Language Server Protocol and their counterparts here: files as URIs, places as
// line and UTF-16 unit from 0. Places that do not exist become the nearest that does; one between
// the halves of a character is behind it.
#pragma once

#include "editor/edited_file.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

using Json = nlohmann::json;

/// `file:///a%20b.pov` to `/a b.pov`; another URI is taken as it is.
std::string path_of(std::string_view uri);
std::string uri_of(std::string_view path);

/// Whether brackets of a JSON text nest deeper than that, to be asked before it is parsed. What is
/// no JSON may count as more or less.
bool nests_deeper(std::string_view json, int most);

std::uint32_t offset_of(std::string_view text, const Json& position);
Json position_of(std::string_view text, std::uint32_t offset);
Json range_of(std::string_view text, Part);

/// Where the lines of a text begin: gives many ranges of it without counting lines each time. The
/// text must live as long.
class LineTable {
public:
    explicit LineTable(std::string_view text);
    /// From 0.
    std::size_t line_of(std::uint32_t offset) const;
    Json position_of(std::uint32_t offset) const;
    Json range_of(Part) const;

private:
    std::string_view text_;
    std::vector<std::uint32_t> starts_;
};

/// Lines and columns of many places that come in the order of the text: takes one walk over it,
/// also where all of it is one line. The text must live as long.
class TextWalk {
public:
    explicit TextWalk(std::string_view text) : text_(text) {}

    /// An offset that is not before the last one.
    void go_to(std::uint32_t offset);
    int line() const { return line_; }
    int column() const { return column_; }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t next_ = 0;  ///< the begin of the next line
    int line_ = -1;
    int column_ = 0;
};

}  // namespace candelabra
