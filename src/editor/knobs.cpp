// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/knobs.h"

#include "editor/edited_file.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <system_error>

namespace candelabra {

namespace {

/// Reads a comment from left to right.
class Words {
public:
    explicit Words(std::string_view text) : rest_(text) {}

    std::optional<double> number() {
        skip_blanks();
        double value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc()) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    bool word(std::string_view wanted) {
        skip_blanks();
        if (!rest_.starts_with(wanted)) return false;
        rest_.remove_prefix(wanted.size());
        return true;
    }

    std::string_view rest() {
        skip_blanks();
        return rest_.substr(0, rest_.find_last_not_of(" \t\r") + 1);
    }

private:
    void skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
    }

    std::string_view rest_;
};

/// Returns the signed value of the tokens between the equals sign and #end; nothing for an
/// expression.
std::optional<double> plain_value(const EditedFile& file, const Token* token) {
    const bool negative = token->kind == TokenKind::minus;
    if (negative) ++token;
    if (token->kind != TokenKind::number || token[1].kind != TokenKind::semicolon ||
        token[2].kind != TokenKind::hash_end)
        return std::nullopt;
    return (negative ? -1 : 1) * file.values.numbers[token->value];
}

std::optional<Knob> knob(const EditedFile& file, const Names& names, const Token* token) {
    using enum TokenKind;
    constexpr TokenKind form[] = {
        hash_ifdef, open_parenthesis, name, close_parenthesis, hash_declare, name, equal};
    for (std::size_t i = 0; i < std::size(form); ++i)
        if (token[i].kind != form[i]) return std::nullopt;
    if (token[0].value != 1 || token[2].value != token[5].value) return std::nullopt;
    const std::optional<double> value = plain_value(file, token + std::size(form));
    if (!value) return std::nullopt;
    const Token& end =
        *std::find_if(token, token + 12, [](const Token& each) { return each.kind == hash_end; });
    const auto comment = std::ranges::lower_bound(file.comments, end.last, {}, &Part::first);
    if (comment == file.comments.end()) return std::nullopt;
    const std::string_view gap = file.part({end.last, comment->first});
    if (gap.find_first_not_of(" \t") != gap.npos) return std::nullopt;
    Words words(file.part(*comment));
    if (!words.word("//")) return std::nullopt;
    const auto low = words.number();
    if (!low || !words.word("to")) return std::nullopt;
    const auto high = words.number();
    if (!high || !(*low < *high)) return std::nullopt;
    const auto step = words.word("by") ? words.number() : std::optional((*high - *low) / 100);
    if (!step || !(*step > 0)) return std::nullopt;
    words.word(":");
    return Knob{std::string(names.spelling(NameId(token[2].value))),
                *value,
                *low,
                *high,
                *step,
                std::string(words.rest())};
}

}  // namespace

std::vector<Knob> knobs(std::string_view scene) {
    Names names;
    EditedFile file = read_tokens(std::string(scene), names);
    const std::size_t count = file.tokens.size();
    file.tokens.resize(count + 12);  // so that matching a form never reads past the end
    std::vector<Knob> found;
    for (std::size_t i = 0; i < count; ++i)
        if (auto one = knob(file, names, &file.tokens[i])) found.push_back(std::move(*one));
    return found;
}

}  // namespace candelabra
