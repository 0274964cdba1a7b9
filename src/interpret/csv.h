// SPDX-License-Identifier: GPL-3.0-or-later
// Reads tables of numbers and strings, one row a line, in the many text forms that programs write.
// Called by read_csv(); knows no files. Time and memory are linear in the text.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// The properties of a table's form that the scene states. Others are detected.
struct CsvForm {
    enum class Header : std::uint8_t { found, there, none };

    Header header = Header::found;  ///< found: the first row, if none of its cells is a number
    char separator = 0;             ///< 0: detected; ' ': any number of blanks and tabs
    bool text = false;              ///< every cell is a string

    /// Applies a word of the options: header, no_header, text, comma, semicolon, tab, bar, blank.
    /// Returns false for other words.
    bool take(std::string_view word);
};

/// The words that CsvForm::take() knows, for messages.
inline constexpr std::string_view csv_words =
    "header, no_header, text, comma, semicolon, tab, "
    "bar and blank";

/// The reason why a text is not a table.
struct CsvProblem {
    std::size_t first = 0, last = 0;  ///< range of the error, in bytes
    std::string message;              ///< continues the name of the file and the line
    bool too_many = false;            ///< more cells than are allowed
};

/// The first cell of a column that is no number, although most of the column's cells are.
struct CsvStray {
    std::size_t first = 0, last = 0;  ///< range in the text, in bytes
    std::size_t column = 0;
};

struct CsvTable {
    std::vector<std::string> names;  ///< of the columns; empty: the table has no header
    bool decimal_comma = false;      ///< 1,5 is one and a half
    std::size_t rows = 0, columns = 0;
    /// The numbers of all rows, one after the other; an empty cell is NaN.
    std::vector<double> numbers;
    /// The cells of all columns, instead of `numbers`, if a column is not numeric.
    std::vector<std::string> cells;
    enum class Kind : std::uint8_t { numbers, colours, strings };
    std::vector<Kind> kinds;  ///< of the columns, if there are `cells`
    std::vector<CsvStray> strays;
};

/// Returns the table, or nothing and the reason. `most`: maximum number of cells.
std::optional<CsvTable> read_csv(std::string_view text, const CsvForm&, std::size_t most,
                                 CsvProblem&);

/// The number in a cell, NaN for an empty cell; nothing if it is not a number.
std::optional<double> csv_number(std::string_view cell, bool decimal_comma);

/// Red, green, blue and opacity, 0 to 1, of a cell such as #ff8800, #f80 or #rrggbbaa.
std::array<double, 4> csv_colour(std::string_view cell);

}  // namespace candelabra
