// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/road_tables.h"

#include "interpret/csv.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace candelabra {

std::string read_road_table(std::string_view text, RoadTable& table) {
    constexpr std::size_t most_cells = 100'000;
    CsvForm form;
    form.header = CsvForm::Header::there;
    CsvProblem trouble;
    const auto read = read_csv(text, form, most_cells, trouble);
    if (!read) return trouble.message;
    if (!read->cells.empty()) return "a cell below the first row is not a number";
    const auto number = [&](std::string_view cell) {
        return csv_number(cell, read->decimal_comma)
            .value_or(std::numeric_limits<double>::quiet_NaN());
    };
    for (std::size_t i = 1; i < read->names.size(); ++i)
        table.angles.push_back(number(read->names[i]));
    for (std::size_t row = 0; row < read->rows; ++row)
        for (std::size_t column = 0; column < read->columns; ++column) {
            const double cell = read->numbers[row * read->columns + column];
            if (column == 0)
                table.tangents.push_back(cell);
            else
                table.entries.push_back(std::isnan(cell) ? 0 : cell);
        }
    return problem(table);
}

}  // namespace candelabra
