// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a table in a text, and the cells in a line. For csv.cpp only.
#pragma once

#include "interpret/csv.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

/// The range of a cell's text, without blanks around it and without its quotes.
struct CsvCell {
    std::size_t first = 0, last = 0;
    bool quoted = false;

    bool empty() const { return !quoted && first == last; }
};

/// Iterates over the lines of a table.
class CsvRows {
public:
    /// `max_cells`: maximum number of cells in a row.
    CsvRows(std::string_view text, std::size_t max_cells);

    std::string_view text() const { return text_; }
    std::string_view text(const CsvCell& cell) const {
        return text_.substr(cell.first, cell.last - cell.first);
    }
    /// The text of a cell, with two quotes inside quotes replaced by one.
    std::string content(const CsvCell&) const;
    std::size_t at() const { return at_; }
    void go_to(std::size_t at) { at_ = at; }

    /// Moves to the next line that is neither empty nor a comment; false at the end.
    bool find_row();
    /// The separator of the current line: the first of tab, semicolon, comma, bar and blank that
    /// occurs in it.
    char find_separator() const;
    /// Reads the cells of the current line and moves past it. A quoted cell may contain line ends.
    bool take_row(char separator, std::vector<CsvCell>& cells, CsvProblem& problem);
    /// A faster take_row() for rows of `columns` numbers and nothing else. Returns false, with no
    /// effect, for other rows.
    bool take_numbers(char separator, std::size_t columns, std::vector<double>& numbers);

private:
    std::size_t line_end(std::size_t from) const;
    bool comment_begins(std::size_t i) const;
    std::pair<std::size_t, std::size_t> inner(char separator) const;
    bool take_quoted(char separator, std::size_t& i, std::size_t& last, CsvCell&, CsvProblem&);

    std::string_view text_;
    std::size_t max_cells_;
    std::size_t at_ = 0;
};

/// Whether a cell is a colour, `#ff8800`, which does not begin a comment.
bool is_hex_colour(std::string_view cell);

}  // namespace candelabra
