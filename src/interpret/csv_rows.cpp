// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/csv_rows.h"

#include "base/number_text.h"

#include <array>
#include <cstdint>
#include <system_error>

namespace candelabra {

namespace {

constexpr auto nowhere = std::string_view::npos;
constexpr std::string_view opening_brackets = "[({<", closing_brackets = "])}>";

bool is_gap(char c) { return c == ' ' || c == '\t'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_among(char c, std::string_view list) { return list.find(c) != nowhere; }

bool is_comment(std::string_view line) {
    if (line.starts_with("//")) return true;
    return line.starts_with('#') && !is_hex_colour(line.substr(0, line.find_first_of(" \t,;|")));
}

bool take_number(const char*& at, const char* end, double& result) {
    const char first = at < end && *at == '-' && at + 1 < end ? at[1] : at < end ? *at : ' ';
    if (first != '.' && (first < '0' || first > '9')) return false;
    const auto [behind, failure] = number_from(at, end, result);
    if (failure != std::errc()) return false;
    at = behind;
    return true;
}

}  // namespace

bool is_hex_colour(std::string_view cell) {
    if (!cell.starts_with('#')) return false;
    cell.remove_prefix(1);
    const bool of_a_colour = cell.size() == 3 || cell.size() == 6 || cell.size() == 8;
    return of_a_colour && cell.find_first_not_of("0123456789abcdefABCDEF") == nowhere;
}

CsvRows::CsvRows(std::string_view text, std::size_t max_cells)
    : text_(text), max_cells_(max_cells) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

std::string CsvRows::content(const CsvCell& cell) const {
    const std::string_view text = this->text(cell);
    if (!cell.quoted || text.find('"') == nowhere) return std::string(text);
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        result += text[i];
        if (text[i] == '"') ++i;
    }
    return result;
}

bool CsvRows::find_row() {
    while (at_ < text_.size()) {
        const std::size_t end = line_end(at_);
        std::size_t first = at_;
        while (first < end && is_gap(text_[first])) ++first;
        if (first < end && !is_comment(text_.substr(first, end - first))) return true;
        at_ = end == text_.size() ? end : end + 1;
    }
    return false;
}

char CsvRows::find_separator() const {
    const auto [first, last] = inner(0);
    bool tab = false, semicolon = false, comma = false, bar = false, blank = false;
    bool quoted = false;
    for (std::size_t i = first; i < last && !(comment_begins(i) && !quoted); ++i) {
        const char c = text_[i];
        quoted ^= c == '"';
        if (quoted) continue;
        const bool behind_other = i > first && is_among(text_[i - 1], ",;");
        tab |= c == '\t' && !behind_other;
        semicolon |= c == ';' && i + 1 < last;
        comma |= c == ',';
        bar |= c == '|';
        blank |= c == ' ';
    }
    return tab ? '\t' : semicolon ? ';' : comma ? ',' : bar ? '|' : blank ? ' ' : ',';
}

bool CsvRows::take_row(char separator, std::vector<CsvCell>& cells, CsvProblem& problem) {
    cells.clear();
    auto [i, last] = inner(separator);
    if (separator != ';' && last > i && text_[last - 1] == ';') --last;
    const bool blanks = separator == ' ';
    const auto separates = [&](char c) { return blanks ? is_gap(c) : c == separator; };
    for (bool more = true; more; ++i) {
        while (i < last && is_gap(text_[i]) && (blanks || text_[i] != separator)) ++i;
        if (blanks && !cells.empty() && (i >= last || comment_begins(i))) break;
        CsvCell cell{i, i, i < last && text_[i] == '"'};
        if (cell.quoted) {
            if (!take_quoted(separator, i, last, cell, problem)) return false;
        } else {
            while (i < last && !separates(text_[i]) && !comment_begins(i)) ++i;
            cell.last = i;
            while (cell.last > cell.first && is_gap(text_[cell.last - 1])) --cell.last;
        }
        cells.push_back(cell);
        if (cells.size() > max_cells_) {
            problem = {cell.first, cell.last, {}, true};
            return false;
        }
        more = i < last && !comment_begins(i);
    }
    at_ = line_end(last);
    if (at_ < text_.size()) ++at_;
    return true;
}

/// Takes a cell whose opening quote is at i, and checks the text after it.
bool CsvRows::take_quoted(char separator, std::size_t& i, std::size_t& last, CsvCell& cell,
                          CsvProblem& problem) {
    std::size_t end = text_.find('"', i + 1);
    while (end != nowhere && end + 1 < text_.size() && text_[end + 1] == '"')
        end = text_.find('"', end + 2);
    if (end == nowhere) {
        problem = {i, i + 1, "begins a quoted cell that does not end", false};
        return false;
    }
    cell.first = i + 1;
    cell.last = end;
    i = end + 1;
    if (i > last) last = line_end(i);
    while (i < last && is_gap(text_[i]) && text_[i] != separator) ++i;
    const bool blank_behind = separator == ' ' && i > end + 1;
    if (i >= last || text_[i] == separator || blank_behind || comment_begins(i)) {
        i -= blank_behind;
        return true;
    }
    problem = {i, i + 1, "has something behind a quoted cell", false};
    return false;
}

bool CsvRows::take_numbers(char separator, std::size_t columns, std::vector<double>& numbers) {
    const char* p = text_.data() + at_;
    const char* const end = text_.data() + text_.size();
    const std::size_t before = numbers.size();
    const bool blanks = separator == ' ';
    while (p < end && is_line_end(*p)) ++p;
    for (std::size_t column = 0; column < columns; ++column) {
        while (p < end && *p == ' ') ++p;
        double number = 0;
        if (!take_number(p, end, number)) break;
        numbers.push_back(number);
        const char* const behind = p;
        while (p < end && *p == ' ') ++p;
        const bool at_end = p == end || is_line_end(*p);
        if (at_end != (column + 1 == columns)) break;
        if (at_end) {
            at_ = static_cast<std::size_t>(p - text_.data()) + (p < end);
            return true;
        }
        if (blanks ? p == behind : *p != separator) break;
        if (!blanks) ++p;
    }
    numbers.resize(before);
    return false;
}

std::size_t CsvRows::line_end(std::size_t from) const {
    const std::size_t end = text_.find_first_of("\n\r", from);
    return end == nowhere ? text_.size() : end;
}

/// Whether a comment begins here, after a blank: `1, 2 // here` or `1, 2 # here`.
bool CsvRows::comment_begins(std::size_t i) const {
    if (i == 0 || i + 1 >= text_.size() || !is_gap(text_[i - 1])) return false;
    return text_[i] == '/' ? text_[i + 1] == '/' : text_[i] == '#' && is_gap(text_[i + 1]);
}

/// The current line without outer blanks, and without brackets around all of it: `[1, 2, 3],`.
std::pair<std::size_t, std::size_t> CsvRows::inner(char separator) const {
    std::size_t first = at_, last = line_end(at_);
    const auto skips = [&](char c) { return is_gap(c) && c != (separator == '\t' ? '\t' : 0); };
    const auto skip_gaps = [&] {
        while (first < last && skips(text_[first])) ++first;
        while (first < last && skips(text_[last - 1])) --last;
    };
    skip_gaps();
    if (first == last || !is_among(text_[first], opening_brackets)) return {first, last};
    const std::pair whole{first, last};
    for (std::size_t i = first; i < last; ++i)
        if (comment_begins(i)) last = i;
    skip_gaps();
    if (is_among(text_[last - 1], ",;")) --last;
    skip_gaps();
    if (first == last || !is_among(text_[last - 1], closing_brackets)) return whole;
    while (first < last && is_among(text_[last - 1], closing_brackets)) --last;
    while (first < last && is_among(text_[first], opening_brackets)) ++first;
    skip_gaps();
    return {first, last};
}

}  // namespace candelabra
