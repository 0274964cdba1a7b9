// SPDX-License-Identifier: GPL-3.0-or-later
// A table as text, in the many forms in which programs write one: numbers and strings, one row a
// line. Called by read_csv(); knows no files. Time and memory grow with the text and no faster.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// What the scene says about the form; the rest is found.
struct CsvForm {
    enum class Header : std::uint8_t { found, there, none };

    Header header = Header::found;  ///< found: the first row, when none of its cells is a number
    char separator = 0;             ///< 0: found; ' ': any number of blanks and tabs
    bool text = false;              ///< every cell is a string

    /// Takes a word of the options: header, no_header, text, comma, semicolon, tab, bar, blank.
    /// False: there is no such word.
    bool take(std::string_view word);
};

/// The words that CsvForm::take() knows, for messages.
inline constexpr std::string_view csv_words =
    "header, no_header, text, comma, semicolon, tab, "
    "bar and blank";

/// Why a text is no table.
struct CsvProblem {
    std::size_t first = 0, last = 0;  ///< the bytes concerned
    std::string message;              ///< goes on behind the name of the file and the line
    bool too_many = false;            ///< there are more cells than are allowed
};

struct CsvTable {
    std::vector<std::string> names;  ///< of the columns; empty: the table has no header
    bool decimal_comma = false;      ///< 1,5 is one number and a half
    std::size_t rows = 0, columns = 0;
    /// The numbers of all rows, one after the other; an empty cell is not a number (NaN).
    std::vector<double> numbers;
    /// Instead of `numbers`, where a column is not of numbers: the cells of all columns.
    std::vector<std::string> cells;
    enum class Kind : std::uint8_t { numbers, colours, strings };
    std::vector<Kind> kinds;  ///< of the columns, where there are `cells`
};

/// The table, or nothing and the reason. `most`: how many cells there may be.
std::optional<CsvTable> read_csv(std::string_view text, const CsvForm&, std::size_t most,
                                 CsvProblem&);

/// A cell as a number, NaN for an empty one; a comma may be the point. Nothing: it is none.
std::optional<double> csv_number(std::string_view cell, bool decimal_comma);

/// A cell such as #ff8800 or #f80 as red, green, blue and, of #rrggbbaa, opacity, from 0 to 1.
std::array<double, 4> csv_colour(std::string_view cell);

}  // namespace candelabra
