// SPDX-License-Identifier: GPL-3.0-or-later
// Contact sheets: pictures of one scene side by side, which differ in the values of one or two
// names. Does no input or output.
#pragma once

#include "options/options.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct Sheet {
    struct Name {
        std::string name;            ///< a variable of the scene, or clock
        std::vector<double> values;  ///< at most as many as there are places for them
    };

    int columns = 0, rows = 0;
    /// One name, whose values follow each other along the rows, or two: the value of the first
    /// belongs to the column, and that of the second to the row.
    std::vector<Name> names;

    int pictures() const;
    int column_of(int picture) const { return picture % in_a_row(); }
    int row_of(int picture) const { return picture / in_a_row(); }
    /// The values of the names in that picture, counted from 0.
    std::vector<Declaration> values_in(int picture) const;

private:
    int in_a_row() const;
};

/// Reads `4x3 Seed=1..12`, or `4x3 Seed=1..4 Height=1,2.5,3`. A range has as many values as places,
/// at even distances. Returns nothing, with the problem as a sentence, for other texts.
std::optional<Sheet> sheet_of(std::string_view text, std::string& problem);

/// Returns the options of one picture of the sheet.
Options with_values(Options, const std::vector<Declaration>&);

}  // namespace candelabra
