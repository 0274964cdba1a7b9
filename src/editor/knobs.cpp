// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/knobs.h"

#include "base/number_text.h"
#include "editor/edited_file.h"
#include "text/decimal.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <system_error>

namespace candelabra {

namespace {

nlohmann::json json_of(const KnobValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* number = std::get_if<double>(&value)) return *number;
    const Vec3 vector = std::get<Numbers>(value).vec3();
    return {vector.x, vector.y, vector.z};
}


/// Most tokens of a default: `rgb <1, 0.5, 0>` has two.
constexpr std::size_t most_tokens = 2;
/// Bytes of a text that the page may set.
constexpr std::size_t longest_text = 10'000;

/// Reads a comment from left to right.
class Words {
public:
    explicit Words(std::string_view text) : rest_(text) {}

    std::optional<double> number() {
        skip_blanks();
        double value = 0;
        const auto [end, error] = number_from(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc()) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    /// Reads a text in quotes.
    std::optional<std::string> quoted() {
        skip_blanks();
        const std::size_t end = rest_.starts_with('"') ? rest_.find('"', 1) : rest_.npos;
        if (end == rest_.npos) return std::nullopt;
        std::string text(rest_.substr(1, end - 1));
        rest_.remove_prefix(end + 1);
        return text;
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

/// Returns the value of the tokens of a declaration; nothing for an expression.
std::optional<KnobValue> plain_value(const EditedFile& file, const Names& names,
                                     std::span<const Token> tokens) {
    const bool negative = !tokens.empty() && tokens.front().kind == TokenKind::minus;
    const bool coloured = !tokens.empty() && tokens.front().kind == TokenKind::colour_prefix &&
                          names.spelling(NameId(tokens.front().value)) == "rgb";
    if (negative || coloured) tokens = tokens.subspan(1);
    if (tokens.size() != 1) return std::nullopt;
    const Token& token = tokens.front();
    if (token.kind == TokenKind::number && !coloured)
        return (negative ? -1 : 1) * file.values.numbers[token.value];
    if (token.kind == TokenKind::text && !negative && !coloured)
        return file.values.texts[token.value];
    if (token.kind != TokenKind::literal || token.count != 3 || negative) return std::nullopt;
    Numbers numbers = Numbers::vector(Vec3(0));
    for (std::size_t i = 0; i < 3; ++i) numbers.at[i] = file.values.numbers[token.value + i];
    if (coloured) numbers.count = 5;
    return numbers;
}

bool read_choices(Words& words, Knob& knob) {
    const bool texts = std::holds_alternative<std::string>(knob.value);
    do {
        std::optional<KnobValue> choice;
        if (texts)
            choice = words.quoted();
        else
            choice = words.number();
        if (!choice) return false;
        knob.choices.push_back(std::move(*choice));
    } while (words.word(","));
    knob.kind = Knob::Kind::list;
    return std::ranges::find(knob.choices, knob.value) != knob.choices.end();
}

bool read_range(Words& words, Knob& knob) {
    const auto low = words.number();
    if (!low || !words.word("to")) return false;
    const auto high = words.number();
    if (!high || !(*low < *high)) return false;
    const auto step = words.word("by") ? words.number() : std::optional((*high - *low) / 100);
    if (!step || !(*step > 0)) return false;
    knob.low = *low;
    knob.high = *high;
    knob.step = *step;
    return true;
}

/// Reads what the comment says of the knob, whose default is known.
bool read_form(Words& words, Knob& knob) {
    using enum Knob::Kind;
    if (std::holds_alternative<Numbers>(knob.value)) {
        knob.kind = words.word("colour") || words.word("color") ? colour : vector;
        return knob.kind == colour || read_range(words, knob);
    }
    if (words.word("one of")) return read_choices(words, knob);
    if (std::holds_alternative<std::string>(knob.value)) {
        knob.kind = text;
        return words.word("text");
    }
    if (words.word("on or off")) {
        knob.kind = toggle;
        return std::get<double>(knob.value) == 0 || std::get<double>(knob.value) == 1;
    }
    return read_range(words, knob);
}

std::optional<Knob> knob(const EditedFile& file, const Names& names, const Token* token) {
    using enum TokenKind;
    constexpr TokenKind form[] = {
        hash_ifdef, open_parenthesis, name, close_parenthesis, hash_declare, name, equal};
    for (std::size_t i = 0; i < std::size(form); ++i)
        if (token[i].kind != form[i]) return std::nullopt;
    if (token[0].value != 1 || token[2].value != token[5].value) return std::nullopt;
    const Token* const first = token + std::size(form);
    std::size_t count = 0;
    while (count <= most_tokens && first[count].kind != semicolon) ++count;
    const Token& end = first[count + 1];
    if (count > most_tokens || end.kind != hash_end) return std::nullopt;
    std::optional<KnobValue> value = plain_value(file, names, {first, count});
    if (!value) return std::nullopt;
    const auto comment = std::ranges::lower_bound(file.comments, end.last, {}, &Part::first);
    if (comment == file.comments.end()) return std::nullopt;
    const std::string_view gap = file.part({end.last, comment->first});
    if (gap.find_first_not_of(" \t") != gap.npos) return std::nullopt;
    Words words(file.part(*comment));
    Knob made{std::string(names.spelling(NameId(token[2].value))), std::move(*value)};
    if (!words.word("//") || !read_form(words, made)) return std::nullopt;
    words.word(":");
    made.help = words.rest();
    return made;
}

/// Returns the name of the section that the text before a place has begun last.
std::string section_before(const EditedFile& file, std::uint32_t place) {
    std::string section;
    for (const Part& each : file.comments) {
        if (each.first >= place) break;
        Words words(file.part(each));
        if (!words.word("//") || !words.word("[")) continue;
        const std::string_view name = words.rest();
        if (name.ends_with(']')) section = name.substr(0, name.size() - 1);
    }
    return section;
}

std::optional<Numbers> numbers_in(std::string_view text, const Numbers& like) {
    Numbers numbers = like;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t end = std::min(text.find(','), text.size());
        const auto value = finite_number(text.substr(0, end));
        if (!value || (end == text.size()) != (i == 2)) return std::nullopt;
        numbers.at[i] = *value;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return numbers;
}

}  // namespace

std::vector<Knob> knobs(std::string_view scene) {
    Names names;
    EditedFile file = read_tokens(std::string(scene), names);
    const std::size_t count = file.tokens.size();
    file.tokens.resize(count + 12);  // so that matching a form never reads past the end
    std::vector<Knob> found;
    for (std::size_t i = 0; i < count; ++i)
        if (auto one = knob(file, names, &file.tokens[i])) {
            one->section = section_before(file, file.tokens[i].first);
            found.push_back(std::move(*one));
        }
    return found;
}

std::optional<KnobValue> knob_value(const Knob& knob, std::string_view stated) {
    using enum Knob::Kind;
    if (const auto* like = std::get_if<Numbers>(&knob.value)) {
        auto numbers = numbers_in(stated, *like);
        if (!numbers) return std::nullopt;
        for (std::size_t i = 0; i < 3; ++i)
            numbers->at[i] = knob.kind == colour ? std::max(numbers->at[i], 0.0)
                                                 : std::clamp(numbers->at[i], knob.low, knob.high);
        return *numbers;
    }
    std::optional<KnobValue> value;
    if (!std::holds_alternative<std::string>(knob.value))
        value = finite_number(stated);
    else if (stated.size() <= longest_text && stated.find('"') == stated.npos)
        value = std::string(stated);
    if (!value) return std::nullopt;
    if (knob.kind == list && std::ranges::find(knob.choices, *value) == knob.choices.end())
        return std::nullopt;
    if (knob.kind == toggle) return std::get<double>(*value) != 0 ? 1.0 : 0.0;
    if (knob.kind == slider) return std::clamp(std::get<double>(*value), knob.low, knob.high);
    return value;
}

nlohmann::json json_of(const Knob& knob, const KnobValue& value) {
    // In the order of the kinds.
    static constexpr std::array kinds = {"slider", "toggle", "list", "text", "colour", "vector"};
    nlohmann::json choices = nlohmann::json::array();
    for (const KnobValue& each : knob.choices) choices.push_back(json_of(each));
    return {{"name", knob.name},       {"kind", kinds[static_cast<std::size_t>(knob.kind)]},
            {"value", json_of(value)}, {"low", knob.low},
            {"high", knob.high},       {"step", knob.step},
            {"choices", choices},      {"help", knob.help},
            {"section", knob.section}};
}

}  // namespace candelabra
