// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/data_reader.h"

#include "text/message.h"

#include <algorithm>

namespace candelabra {

DataReader::DataReader(SourceId source, const SourceStore& sources, Names& names,
                       Diagnostics& diagnostics)
    : source_(source),
      sources_(sources),
      diagnostics_(diagnostics),
      lexer_(source, sources, names, tree_, diagnostics) {
    advance();
}

void DataReader::advance() {
    // Only the number or string of the token ahead is still needed.
    tree_.numbers.clear();
    tree_.texts.clear();
    taken_ = ahead_.last;
    ahead_ = lexer_.next();
}

std::optional<Value> DataReader::next() {
    if (ahead_.kind == TokenKind::end_of_file) {
        after_comma_ = false;
        behind_line_end_ = false;
        return std::nullopt;
    }
    const std::uint32_t first = ahead_.first;
    if (place_.known())
        behind_line_end_ =
            sources_.text(source_).substr(place_.last, first - place_.last).find_first_of("\n\r") !=
            std::string_view::npos;
    Value result = value();
    place_ = {source_, first, taken_};
    after_comma_ = ahead_.kind == TokenKind::comma;
    if (after_comma_) advance();
    return result;
}

Value DataReader::value() {
    switch (ahead_.kind) {
        case TokenKind::text: {
            std::string text = tree_.texts[ahead_.value];
            advance();
            return text;
        }
        case TokenKind::literal: {
            Numbers numbers;
            numbers.count = ahead_.count;
            std::copy_n(tree_.numbers.begin() + ahead_.value, ahead_.count, numbers.at.begin());
            advance();
            return numbers;
        }
        case TokenKind::less:
            return vector();
        default:
            if (const auto found = number()) return *found;
            return not_a_value();
    }
}

std::optional<double> DataReader::number() {
    const bool negative = ahead_.kind == TokenKind::minus;
    if (negative || ahead_.kind == TokenKind::plus) advance();
    if (ahead_.kind != TokenKind::number) return std::nullopt;
    const double size = tree_.numbers[ahead_.value];
    advance();
    return negative ? -size : size;
}

/// Reads `< ... >` in forms that are not one token: with comments, or without commas.
Value DataReader::vector() {
    const std::uint32_t first = ahead_.first;
    advance();
    Numbers result;
    result.count = 0;
    while (ahead_.kind != TokenKind::greater) {
        if (result.count == 5) break;
        const auto found = number();
        if (!found) return not_a_value();
        result.at[static_cast<std::size_t>(result.count++)] = *found;
        if (ahead_.kind == TokenKind::comma) advance();
    }
    if (result.count < 2 || ahead_.kind != TokenKind::greater) {
        diagnostics_.add(error(Fault::wrong_count, {source_, first, ahead_.last},
                               "a vector in a data file has 2 to 5 numbers"));
        return Absence::broken;
    }
    advance();
    return result;
}

Value DataReader::not_a_value() {
    const Span span{source_, ahead_.first, ahead_.last};
    diagnostics_.add(error(Fault::wrong_type, span, "this is no value that #read can take")
                         .with_help("a data file holds numbers, strings and vectors, with commas "
                                    "between them"));
    return Absence::broken;
}

}  // namespace candelabra
