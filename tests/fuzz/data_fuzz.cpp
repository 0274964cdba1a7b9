// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a table and as JSON, whose form the first byte says: no crash, and as many cells as
// rows and columns say.
#include "fuzz/target.h"
#include "interpret/csv.h"
#include "interpret/json_reader.h"

#include <array>
#include <cstdlib>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    constexpr std::size_t most = 5000;
    constexpr std::string_view separators = {"\0,;\t| ", 6};
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    CsvForm form;
    form.separator = separators[data[0] % separators.size()];
    form.header = static_cast<CsvForm::Header>(data[0] / 6 % 3);
    form.text = data[0] / 18 % 2 == 1;
    CsvProblem problem;
    if (const auto table = read_csv(text, form, most, problem)) {
        const std::size_t cells = table->rows * table->columns;
        if (cells == 0 || cells > most) std::abort();
        if (table->numbers.size() + table->cells.size() != cells) std::abort();
        if (!table->names.empty() && table->names.size() != table->columns) std::abort();
        if (!table->cells.empty() && table->kinds.size() != table->columns) std::abort();
    } else if (problem.first > text.size() || problem.last > text.size() + 1) {
        std::abort();
    }
    JsonProblem wrong;
    if (!read_json(text, most, wrong) && wrong.message.empty()) std::abort();
    return 0;
}
