// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/lexer.h"

#include "base/number_text.h"
#include "syntax/escapes.h"
#include "text/ascii.h"
#include "text/decimal.h"
#include "text/message.h"
#include "text/nearest.h"
#include "vocabulary/reserved.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

namespace candelabra {

Lexer::Lexer(SourceId source, const SourceStore& sources, Names& names, Tree& tree,
             Diagnostics& diagnostics, double version)
    : begin_(sources.text(source).data()),
      cursor_(begin_),
      limit_(begin_ + sources.text(source).size()),
      source_(source),
      names_(names),
      tree_(tree),
      diagnostics_(diagnostics),
      version_(version) {
    if (sources.text(source).starts_with("\xEF\xBB\xBF")) cursor_ += 3;
}

void Lexer::report(Diagnostic diagnostic) {
    if (!quiet_) diagnostics_.add(std::move(diagnostic));
}

Token Lexer::next() {
    const Token result = scan();
    if (previous_ == TokenKind::hash_version && result.kind == TokenKind::number)
        version_ = tree_.numbers[result.value];
    before_previous_ = std::exchange(previous_, result.kind);
    return result;
}

Token Lexer::token(TokenKind kind, const char* first, std::uint32_t value) {
    return {kind, 0, offset(first), offset(cursor_), value};
}

namespace {

TokenKind kind_of(WordClass word_class) {
    switch (word_class) {
        case WordClass::name:
            return TokenKind::name;
        case WordClass::word:
        case WordClass::directive:
            return TokenKind::word;
        case WordClass::unary_function:
            return TokenKind::unary_function;
        case WordClass::function:
            return TokenKind::function;
        case WordClass::constant:
            return TokenKind::constant;
        case WordClass::colour:
            return TokenKind::colour;
        case WordClass::colour_prefix:
            return TokenKind::colour_prefix;
        case WordClass::channel:
            return TokenKind::channel;
        case WordClass::layer:
            return TokenKind::layer;
        case WordClass::array:
            return TokenKind::array;
        case WordClass::function_literal:
            return TokenKind::function_literal;
    }
    return TokenKind::word;
}

struct DirectiveWord {
    std::string_view spelling;
    TokenKind kind;
    std::uint32_t value = 0;
};

constexpr std::uint32_t value_of(MessageKind kind) { return static_cast<std::uint32_t>(kind); }

constexpr auto directive_words = std::array{
    DirectiveWord{"declare", TokenKind::hash_declare},
    DirectiveWord{"local", TokenKind::hash_declare, 1},
    DirectiveWord{"if", TokenKind::hash_if},
    DirectiveWord{"end", TokenKind::hash_end},
    DirectiveWord{"else", TokenKind::hash_else},
    DirectiveWord{"elseif", TokenKind::hash_elseif},
    DirectiveWord{"ifdef", TokenKind::hash_ifdef},
    DirectiveWord{"ifndef", TokenKind::hash_ifdef, 1},
    DirectiveWord{"while", TokenKind::hash_while},
    DirectiveWord{"for", TokenKind::hash_for},
    DirectiveWord{"switch", TokenKind::hash_switch},
    DirectiveWord{"case", TokenKind::hash_case},
    DirectiveWord{"range", TokenKind::hash_range},
    DirectiveWord{"break", TokenKind::hash_break},
    DirectiveWord{"macro", TokenKind::hash_macro},
    DirectiveWord{"include", TokenKind::hash_include},
    DirectiveWord{"default", TokenKind::hash_default},
    DirectiveWord{"undef", TokenKind::hash_undef},
    DirectiveWord{"version", TokenKind::hash_version},
    DirectiveWord{"debug", TokenKind::hash_message, value_of(MessageKind::debug)},
    DirectiveWord{"warning", TokenKind::hash_message, value_of(MessageKind::warning)},
    DirectiveWord{"error", TokenKind::hash_message, value_of(MessageKind::error)},
    DirectiveWord{"render", TokenKind::hash_message, value_of(MessageKind::render)},
    DirectiveWord{"statistics", TokenKind::hash_message, value_of(MessageKind::statistics)},
    DirectiveWord{"fopen", TokenKind::hash_fopen},
    DirectiveWord{"fclose", TokenKind::hash_fclose},
    DirectiveWord{"read", TokenKind::hash_read},
    DirectiveWord{"write", TokenKind::hash_write},
};

/// The directive of a word that means nothing without #; null for other words.
const DirectiveWord* without_hash(std::string_view spelling) {
    constexpr auto words = std::array<std::string_view, 13>{
        "local", "if",  "end",    "else", "elseif", "ifdef", "ifndef",
        "while", "for", "switch", "case", "macro",  "undef"};
    if (std::ranges::find(words, spelling) == words.end()) return nullptr;
    return std::ranges::find(directive_words, spelling, &DirectiveWord::spelling);
}

/// Converts a number of at most 15 digits without an exponent, as nearly all are. Both integers are
/// exact as doubles, so their quotient is correctly rounded.
std::optional<double> convert_short(const char*& p, const char* end) {
    constexpr int max_digits = 15;
    constexpr auto powers = std::array{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                       1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    std::int64_t digits = 0;
    int count = 0, behind_point = 0;
    const char* at = p;
    for (; at < end && is_digit(*at) && count <= max_digits; ++at, ++count)
        digits = 10 * digits + (*at - '0');
    if (at < end && *at == '.')
        for (++at; at < end && is_digit(*at) && count <= max_digits; ++at, ++count, ++behind_point)
            digits = 10 * digits + (*at - '0');
    const bool goes_on = at < end && (*at == 'e' || *at == 'E');
    if (count == 0 || count > max_digits || goes_on) return std::nullopt;
    p = at;
    return static_cast<double>(digits) / powers[static_cast<std::size_t>(behind_point)];
}

double convert(const char*& p, const char* end) {
    const bool negative = *p == '-';
    if (*p == '-' || *p == '+') ++p;
    if (const auto value = convert_short(p, end)) return negative ? -*value : *value;
    double value = 0;
    // An exponent without digits, which the scanner accepts and from_chars does not, is ignored.
    auto [rest, problem] = number_from(p, end, value);
    if (problem == std::errc::result_out_of_range)
        value = underflows({p, static_cast<std::size_t>(rest - p)}) ? 0 : HUGE_VAL;
    p = rest;
    return negative ? -value : value;
}

}  // namespace

Token Lexer::read_word(const char* first) {
    if (foreign_letter()) return read_foreign_word(first);
    const std::string_view spelling(first, static_cast<std::size_t>(cursor_ - first));
    if (spelling == "local" || spelling == "global")
        if (const auto scoped = read_scoped_name(first, spelling)) return *scoped;
    const NameId id = names_.intern(spelling);
    TokenKind kind = kind_of(names_.word_class(id));
    std::uint32_t value = static_cast<std::uint32_t>(id);
    if (kind != TokenKind::name && is_asked_about()) return token(TokenKind::word, first, value);
    last_word_ = id;
    if (id == "version"_word && begins_version()) {
        report_missing_hash(first, spelling);
        return token(TokenKind::hash_version, first);
    }
    if (names_.word_class(id) == WordClass::directive) {
        if (spelling == "deprecated") kind = TokenKind::deprecated;
        if (spelling == "once") kind = TokenKind::once;
        if (const auto* directive = without_hash(spelling)) {
            if (stands_behind_end(first, spelling)) return scan();
            const bool end = previous_ == TokenKind::hash_end;
            report(error(Fault::syntax, span(first, cursor_),
                         message("`", spelling, "` needs a # before it"))
                       .with_help(message("write `#", spelling, "`",
                                          end ? "; `#end` ends any directive by itself" : "")));
            return token(directive->kind, first, directive->value);
        }
        // The oldest scenes leave out the #.
        if (spelling == "declare" || spelling == "include" || spelling == "default") {
            report_missing_hash(first, spelling);
            kind = std::ranges::find(directive_words, spelling, &DirectiveWord::spelling)->kind;
            value = 0;
        }
    }
    if (previous_ == TokenKind::hash_version && spelling == "unofficial")
        kind = TokenKind::unofficial;
    if (id == "xyz"_word) kind = TokenKind::powers;
    if (spelling == "mixed" && previous_ == TokenKind::array) kind = TokenKind::mixed;
    if (spelling == "optional" && goes_on_with('{')) kind = TokenKind::optional_list;
    if (kind == TokenKind::colour && previous_ == kind) return scan();  // `color color Red`
    return token(kind, first, value);
}

bool Lexer::goes_on_with(char sign) const {
    const std::size_t behind = rest().find_first_not_of(" \t\r\n");
    return behind != std::string_view::npos && rest()[behind] == sign;
}

/// Reads `local.N`, `local["N"]`, `global.N` or `global["N"]` after its first word. Nothing if it
/// is none; a scene may have a name `global` of its own.
std::optional<Token> Lexer::read_scoped_name(const char* first, std::string_view word) {
    const bool global = word == "global";
    if (global && names_.find(word) != no_name) return std::nullopt;
    const char* const behind = cursor_;
    const auto take = [&](char sign) {
        skip_blanks();
        const bool found = cursor_ < limit_ && *cursor_ == sign;
        cursor_ += found;
        return found;
    };
    const bool brackets = take('[');
    const bool good = brackets ? take('"') : take('.');
    if (good && !brackets) skip_blanks();
    const char* const begin = cursor_;
    while (good && cursor_ < limit_ && in_name(*cursor_)) ++cursor_;
    const std::string_view name(begin, static_cast<std::size_t>(cursor_ - begin));
    if (name.empty() || is_digit(name[0]) || (brackets && (!take('"') || !take(']')))) {
        cursor_ = behind;
        return std::nullopt;
    }
    const NameId whole = names_.intern(message(word, '.', name));
    tree_.scoped.push_back({whole, names_.intern(name), global});
    last_word_ = whole;
    return token(TokenKind::name, first, static_cast<std::uint32_t>(whole));
}

/// Whether a word has no effect, because it stands in `defined(` or `#ifdef (`.
bool Lexer::is_asked_about() const {
    return previous_ == TokenKind::open_parenthesis &&
           (before_previous_ == TokenKind::hash_ifdef ||
            (before_previous_ == TokenKind::function && last_word_ == "defined"_word));
}

/// Whether the word just read is meant as `#version`: a number follows it, and it stands where no
/// value can precede that number.
bool Lexer::begins_version() const {
    using enum TokenKind;
    constexpr auto before =
        std::array{end_of_file, close_brace, semicolon, hash_end, text, close_parenthesis};
    if (std::ranges::find(before, previous_) == before.end()) return false;
    const std::size_t behind = rest().find_first_not_of(" \t");
    return behind != std::string_view::npos && is_digit(rest()[behind]);
}

Token Lexer::read_directive(const char* hash) {
    skip_blanks();
    const char* const first = cursor_;
    while (cursor_ < limit_ && (is_letter(*cursor_) || (cursor_ > first && is_digit(*cursor_))))
        ++cursor_;
    const std::string_view spelling(first, static_cast<std::size_t>(cursor_ - first));
    if (spelling == "else" && takes_if(hash)) return token(TokenKind::hash_elseif, hash);
    for (const DirectiveWord& directive : directive_words)
        if (directive.spelling == spelling) return token(directive.kind, hash, directive.value);
    if (spelling.empty()) {
        cursor_ = hash + 1;
        report(warning(Fault::syntax, span(hash, cursor_),
                       "this `#` has no effect, for no word follows it"));
        return scan();
    }
    // The `#` is ignored, as in POV-Ray: some programs write `#global_settings`, and the oldest
    // scenes write a setting this way. A name met before may be declared: `object { #Tower }`.
    if (names_.find(spelling) != no_name) {
        if (spelling != "max_trace_level")
            report(
                warning(Fault::syntax, span(hash, hash + 1),
                        message("this `#` has no effect, for `", spelling, "` is no directive")));
        return read_word(first);
    }
    return read_unknown_directive(hash, spelling);
}

Token Lexer::read_unknown_directive(const char* hash, std::string_view spelling) {
    while (cursor_ < limit_ && is_hex_digit(*cursor_)) ++cursor_;
    const std::string_view word(spelling.data(),
                                static_cast<std::size_t>(cursor_ - spelling.data()));
    Diagnostic problem = error(Fault::unknown_word, span(hash, cursor_),
                               message("there is no directive `#", word, "`"));
    if (const std::string colour = hexadecimal_colour(word); !colour.empty()) {
        report(problem.with_help(message("as a colour, write ", colour)));
        return read_hexadecimal_colour(hash, word);
    }
    std::vector<std::string_view> known;
    for (const DirectiveWord& directive : directive_words) known.push_back(directive.spelling);
    std::string guess(foreign_directive(spelling));
    if (guess.empty()) guess = nearest(spelling, known);
    if (quiet_) return scan();
    if (!guess.empty()) {
        problem.with_help(message("did you mean `#", guess, "`?"));
        report(problem);
        for (const DirectiveWord& directive : directive_words)
            if (directive.spelling == guess) return token(directive.kind, hash, directive.value);
    }
    if (guess.empty())
        problem.with_help(takes_comment() ? "a comment begins with `//`"
                                          : std::string(foreign_name(spelling)));
    report(problem);
    return scan();
}

void Lexer::skip_blanks() {
    for (; cursor_ < limit_; ++cursor_) {
        const bool comment = *cursor_ == '/' && cursor_ + 1 < limit_;
        if (comment && cursor_[1] == '/') {
            skip_line_comment();
            if (cursor_ == limit_) return;
        } else if (comment && cursor_[1] == '*') {
            const char* const first = cursor_;
            cursor_ += 2;
            skip_comment(first);
            --cursor_;
        } else if (std::string_view(" \t\r\n\v\f\x1a\0", 8).find(*cursor_) ==
                   std::string_view::npos) {
            return;
        }
    }
}

void Lexer::skip_line_comment() {
    while (cursor_ < limit_ && *cursor_ != '\n' && *cursor_ != '\r') ++cursor_;
}

void Lexer::skip_comment(const char* first) {
    for (int depth = 1; cursor_ + 1 < limit_;) {
        if (cursor_[0] == '*' && cursor_[1] == '/') {
            cursor_ += 2;
            if (--depth == 0) return;
        } else if (cursor_[0] == '/' && cursor_[1] == '*') {
            cursor_ += 2;
            ++depth;
        } else {
            ++cursor_;
        }
    }
    cursor_ = limit_;
    report(error(Fault::unterminated, span(first, first + 2), "this comment has no end")
               .with_help("comments nest: each `/*` needs its own `*/`"));
}

Token Lexer::read_number(const char* first) {
    const bool hexadecimal = cursor_ == first + 1 && *first == '0' && cursor_ + 1 < limit_ &&
                             (*cursor_ | 0x20) == 'x' && is_hex_digit(cursor_[1]);
    if (hexadecimal) {
        double value = HUGE_VAL;  // kept if the number is out of range
        for (++cursor_; cursor_ < limit_ && is_hex_digit(*cursor_);) ++cursor_;
        number_from(first + 2, cursor_, value, std::chars_format::hex);
        report(error(Fault::syntax, span(first, cursor_), "numbers are written in decimal digits")
                   .with_help(message("write ", value)));
    }
    const char* p = first;
    tree_.numbers.push_back(convert(p, cursor_));
    return token(TokenKind::number, first, static_cast<std::uint32_t>(tree_.numbers.size() - 1));
}

Token Lexer::read_literal(const char* first) {
    Token result =
        token(TokenKind::literal, first, static_cast<std::uint32_t>(tree_.numbers.size()));
    for (const char* p = first + 1; p < cursor_ - 1;) {
        if (is_digit(*p) || *p == '.' || *p == '-' || *p == '+') {
            tree_.numbers.push_back(convert(p, cursor_));
            // The rest of an exponent without digits belongs to the number.
            if (*p == 'e' || *p == 'E') p += 1 + (p[1] == '+' || p[1] == '-');
            ++result.count;
        } else {
            ++p;
        }
    }
    return result;
}

bool Lexer::verbatim_expected() const {
    constexpr double first_with_escapes = 3.8;
    if (version_ >= first_with_escapes) return false;
    return previous_ == TokenKind::hash_include || previous_ == TokenKind::word ||
           (previous_ == TokenKind::name && before_previous_ == TokenKind::hash_fopen);
}

Token Lexer::read_text(const char* first) {
    while (cursor_ < limit_ && *cursor_ != '"')
        cursor_ += *cursor_ == '\\' && cursor_ + 1 < limit_ ? 2 : 1;
    const std::string_view raw(first + 1, static_cast<std::size_t>(cursor_ - first - 1));
    if (cursor_ >= limit_) {
        cursor_ = limit_;
        Diagnostic problem =
            error(Fault::unterminated, span(first, first + 1), "this string has no end");
        if (long_string_)
            problem.pointing(*long_string_, "or this one, which goes on over the end of its line");
        report(problem.with_help("a string ends at the next `\"`"));
    } else {
        ++cursor_;
        if (!long_string_ && raw.find_first_of("\r\n") != std::string_view::npos)
            long_string_ = span(first, first + 1);
    }
    // Names of files keep their backslashes, as in POV-Ray before version 3.8.
    const auto index = static_cast<std::uint32_t>(tree_.texts.size());
    if (verbatim_expected()) {
        tree_.verbatim.push_back(index);
        tree_.texts.emplace_back(raw);
    } else {
        tree_.texts.push_back(quiet_ ? std::string(raw)
                                     : unescaped(raw, source_, offset(first + 1), diagnostics_));
    }
    return token(TokenKind::text, first, index);
}

/// Reports text that cannot begin a token. Returns the intended token where it is clear.
std::optional<Token> Lexer::stray(const char* first) {
    cursor_ = first;
    if (const ForeignSign* sign = foreign_sign(rest())) return read_foreign_sign(first, *sign);
    if (foreign_letter()) return read_foreign_word(first);
    ++cursor_;
    Diagnostic problem =
        error(Fault::unknown_character, span(first, cursor_), "this character means nothing here");
    if (*first == '%')
        problem.with_help("the remainder of a division is mod(a, b), its whole part div(a, b)");
    if (*first == '^') problem.with_help("a power is pow(base, exponent)");
    if (*first == '\'') problem.with_help("strings are written in double quotes");
    report(problem);
    // Between two values, an operator that exists takes its place.
    if ((*first == '^' || *first == '%') && between_values()) return token(TokenKind::times, first);
    return std::nullopt;
}

void Lexer::double_sign(const char* first, std::string_view instead) {
    report(error(Fault::syntax, span(first, cursor_),
                 message("this language writes `", instead, "`, not `", instead, instead, "`"))
               .with_help(message("write `", instead, "`")));
}

}  // namespace candelabra
