// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/meters.h"

#include "interpret/csv.h"
#include "meter/road_table.h"
#include "reading/item_block.h"
#include "text/message.h"
#include "text/printable.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace candelabra {

namespace {

/// The table of a CSV file: angles in the first row, tangents in the first column. An empty cell is
/// 0, as in the tables of CIE. Returns an error as a sentence, or an empty string.
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

}  // namespace

bool read_meter(Binder& binder, const Element& element, Meter& meter) {
    if (!read_item(binder, element, meter)) return false;
    if (meter.road_table.empty()) return true;
    Handle<RoadTable>& known = binder.road_tables[meter.road_table];
    if (known) {
        meter.surface = known;
        return true;
    }
    const auto text = binder.evaluator.load_data(meter.road_table, element.word_span);
    if (!text) return false;
    RoadTable table;
    if (const std::string wrong = read_road_table(*text, table); !wrong.empty()) {
        binder.evaluator.report(
            error(Fault::syntax, element.word_span,
                  message("`", printable(meter.road_table), "`: ", wrong))
                .with_help("beta,0,2,5 in the first row, then tan gamma and entries: 0.25,700,700,"
                           "690"));
        return false;
    }
    meter.surface = known = make_handle<RoadTable>(std::move(table));
    return true;
}

}  // namespace candelabra
