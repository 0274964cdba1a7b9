// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/csv.h"

#include "base/number_text.h"
#include "interpret/csv_rows.h"
#include "text/ascii.h"
#include "text/decimal.h"
#include "text/message.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace candelabra {

namespace {

class CsvReader {
public:
    CsvReader(std::string_view text, const CsvForm& form, std::size_t most, CsvProblem& problem)
        : rows_(text, most), form_(form), most_(most), problem_(problem) {}

    std::optional<CsvTable> read() {
        if (!begin()) return std::nullopt;
        const std::size_t start = rows_.at();
        if (form_.text || !read_numbers()) {
            if (failed_) return std::nullopt;
            rows_.go_to(start);
            if (!read_cells()) return std::nullopt;
        }
        if (table_.rows > 0) return std::move(table_);
        problem_ = {0, 0, table_.names.empty() ? "is empty" : "has a header and no row", false};
        return std::nullopt;
    }

private:
    using Kind = CsvTable::Kind;

    bool fail(CsvProblem problem) {
        problem_ = std::move(problem);
        failed_ = true;
        return false;
    }

    /// Finds the separator, the header and the number of columns.
    bool begin() {
        if (!rows_.find_row()) return true;
        separator_ = form_.separator ? form_.separator : rows_.find_separator();
        table_.decimal_comma = separator_ != ',';
        const std::size_t start = rows_.at();
        if (!rows_.take_row(separator_, row_, problem_)) return false;
        // A separator after the last cell does not begin another one.
        if (row_.size() > 1 && row_.back().empty()) row_.pop_back();
        table_.columns = row_.size();
        const bool header = form_.header == CsvForm::Header::there ||
                            (form_.header == CsvForm::Header::found && looks_like_names());
        if (header)
            for (const CsvCell& cell : row_) table_.names.push_back(rows_.content(cell));
        else
            rows_.go_to(start);
        return true;
    }

    bool looks_like_names() const {
        return std::ranges::none_of(row_, [&](const CsvCell& cell) {
            const auto number = csv_number(rows_.text(cell), table_.decimal_comma);
            return (number && !std::isnan(*number)) || is_hex_colour(rows_.text(cell));
        });
    }

    bool take_row() {
        const std::size_t start = rows_.at();
        if (!rows_.take_row(separator_, row_, problem_)) {
            failed_ = true;
            return false;
        }
        if (row_.size() == table_.columns + 1 && row_.back().empty()) row_.pop_back();
        if (row_.size() != table_.columns)
            return fail({row_.front().first, std::max(row_.front().last, row_.back().last),
                         message("has ", row_.size(), row_.size() == 1 ? " cell" : " cells",
                                 ", and ", table_.names.empty() ? "the first row" : "the header",
                                 " has ", table_.columns),
                         false});
        if (++table_.rows > most_ / table_.columns) return fail({start, start, {}, true});
        return true;
    }

    /// False if there are other cells, or after a failure.
    bool read_numbers() {
        const std::string_view rest = rows_.text().substr(rows_.at());
        const auto lines = static_cast<std::size_t>(std::ranges::count(rest, '\n')) + 1;
        table_.numbers.reserve(std::min({rest.size() / 2 + 1, most_, lines * table_.columns}));
        for (;;) {
            if (rows_.take_numbers(separator_, table_.columns, table_.numbers)) {
                if (++table_.rows > most_ / table_.columns)
                    return fail({rows_.at(), rows_.at(), {}, true});
                continue;
            }
            if (!rows_.find_row()) return true;
            if (!take_row()) return false;
            for (const CsvCell& cell : row_) {
                const auto number = csv_number(rows_.text(cell), table_.decimal_comma);
                if (!number) {
                    table_.rows = 0;
                    table_.numbers = {};
                    return false;
                }
                table_.numbers.push_back(*number);
            }
        }
    }

    bool read_cells() {
        std::vector<bool> number(table_.columns, !form_.text), colour = number;
        std::vector<std::size_t> numbers(table_.columns, 0);
        std::vector<CsvStray> first_other(table_.columns);
        while (rows_.find_row()) {
            if (!take_row()) return false;
            for (std::size_t i = 0; i < row_.size(); ++i) {
                std::string text = rows_.content(row_[i]);
                const bool is_number = csv_number(text, table_.decimal_comma).has_value();
                if (is_number) ++numbers[i];
                if (!is_number && number[i]) {
                    number[i] = false;
                    first_other[i] = {row_[i].first, row_[i].last, i};
                }
                if (colour[i]) colour[i] = is_hex_colour(text);
                table_.cells.push_back(std::move(text));
            }
        }
        for (std::size_t i = 0; i < table_.columns; ++i)
            table_.kinds.push_back(number[i]   ? Kind::numbers
                                   : colour[i] ? Kind::colours
                                               : Kind::strings);
        for (std::size_t i = 0; i < table_.columns; ++i)
            if (!form_.text && !number[i] && !colour[i] && 2 * numbers[i] > table_.rows)
                table_.strays.push_back(first_other[i]);
        return true;
    }

    CsvRows rows_;
    const CsvForm& form_;
    std::size_t most_;
    CsvProblem& problem_;
    CsvTable table_;
    std::vector<CsvCell> row_;
    char separator_ = ',';
    bool failed_ = false;
};

}  // namespace

bool CsvForm::take(std::string_view word) {
    constexpr auto separators = std::to_array<std::pair<std::string_view, char>>(
        {{"comma", ','}, {"semicolon", ';'}, {"tab", '\t'}, {"bar", '|'}, {"blank", ' '}});
    for (const auto& [name, sign] : separators)
        if (word == name) {
            separator = sign;
            return true;
        }
    if (word == "header")
        header = Header::there;
    else if (word == "no_header")
        header = Header::none;
    else if (word == "text")
        text = true;
    else
        return false;
    return true;
}

std::optional<double> csv_number(std::string_view cell, bool decimal_comma) {
    if (cell.empty() || same_letters(cell, "nan")) return std::numeric_limits<double>::quiet_NaN();
    if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') cell.remove_prefix(1);
    std::string with_point;
    if (decimal_comma && std::ranges::count(cell, ',') == 1 && cell.find('.') == cell.npos) {
        with_point = cell;
        std::ranges::replace(with_point, ',', '.');
        cell = with_point;
    }
    // Words such as inf are not numbers here.
    const char first = cell[cell.size() > 1 && cell[0] == '-' ? 1 : 0];
    if (first != '.' && !is_digit(first)) return std::nullopt;
    double result = 0;
    const char* const end = cell.data() + cell.size();
    const auto [behind, failure] = number_from(cell.data(), end, result);
    if (behind != end) return std::nullopt;
    if (failure == std::errc()) return result;
    // A number that is too small for a double is 0; one that is too large is not a number.
    if (underflows(cell.substr(cell[0] == '-' ? 1 : 0))) return 0.0;
    return std::nullopt;
}

std::array<double, 4> csv_colour(std::string_view cell) {
    cell.remove_prefix(1);
    const std::size_t digits = cell.size() == 3 ? 1 : 2;
    std::array<double, 4> result{0, 0, 0, 1};
    for (std::size_t i = 0; i * digits < cell.size(); ++i) {
        int value = 0;
        const char* const at = cell.data() + i * digits;
        std::from_chars(at, at + digits, value, 16);
        result[i] = value / (digits == 1 ? 15.0 : 255.0);
    }
    return result;
}

std::optional<CsvTable> read_csv(std::string_view text, const CsvForm& form, std::size_t most,
                                 CsvProblem& problem) {
    return CsvReader(text, form, most, problem).read();
}

}  // namespace candelabra
