// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/token_stream.h"

#include "syntax/balance.h"
#include "vocabulary/reserved.h"

#include <algorithm>
#include <utility>

namespace candelabra {

namespace {

/// Limit of copied tokens. Copies double with each condition of this kind after another.
constexpr std::size_t max_ahead = 100'000;

/// Maximum number of tokens in a directive that is an operand.
constexpr std::size_t longest_value = 500;

/// The pair of parentheses at the start of the text, without blanks.
std::string parenthesised(std::string_view text) {
    std::string result;
    int open = 0;
    for (const char c : text) {
        if (c == ' ' || c == '\t' || c == '\n' || c == '\r') continue;
        result += c;
        open += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (open == 0) break;
    }
    return result;
}

}  // namespace

Token TokenStream::next() {
    for (;;) {
        const Token token = fetch();
        if (names_version_ && token.kind == TokenKind::number) version_ = lexer_.number(token);
        names_version_ = token.kind == TokenKind::hash_version ||
                         (names_version_ && token.kind == TokenKind::unofficial);
        dropped_sign_ = false;
        if (token.kind != TokenKind::hash_if) return token;
        if (drop_false_branch() ? !keep_else() : !choose_branch()) return token;
    }
}

Token TokenStream::fetch() {
    while (ahead_.empty()) {
        const Token token = lexer_.next();
        const TokenKind before = std::exchange(before_, token.kind);
        const bool defined = std::exchange(names_macro_, token.kind == TokenKind::hash_macro);
        if (before == TokenKind::hash_include && token.kind == TokenKind::text && !passing_over_)
            macros_.include(token, version_);
        if (macros_.empty() || token.kind != TokenKind::name || defined || passing_over_ ||
            !call(token, before))
            return token;
    }
    const Token token = ahead_.front();
    ahead_.pop_front();
    return token;
}

Token TokenStream::take(Tokens& taken) {
    taken.push_back(fetch());
    return taken.back();
}

void TokenStream::give_back(const Tokens& taken) {
    ahead_.insert(ahead_.begin(), taken.begin(), taken.end());
}

bool TokenStream::define_open_macro(const Token& opener) {
    Tokens taken{opener};
    for (std::size_t open = 1; open > 0;) {
        const TokenKind kind = take(taken).kind;
        if (opens_directive(kind)) ++open;
        if (kind == TokenKind::hash_end) --open;
        if (kind == TokenKind::end_of_file || taken.size() > max_ahead) break;
    }
    if (taken.back().kind == TokenKind::hash_end && macros_.define(taken)) return true;
    taken.erase(taken.begin());
    return give_back(taken), false;
}

bool TokenStream::call(const Token& name, TokenKind before) {
    OpenMacros::Macro* macro = macros_.find(NameId(name.value), before);
    if (!macro) return false;
    Tokens taken;
    if (!take_parentheses(taken)) return give_back(taken), false;
    give_back(macros_.expand(*macro, name, taken));
    return true;
}

bool TokenStream::drop_false_branch() {
    Tokens taken;
    const TokenKind opener = take(taken).kind;
    const Token value = take(taken);
    const bool never = (value.kind == TokenKind::number && lexer_.number(value) == 0) ||
                       (value.kind == TokenKind::constant &&
                        (NameId(value.value) == "false"_word || NameId(value.value) == "no"_word ||
                         NameId(value.value) == "off"_word));
    if (opener != TokenKind::open_parenthesis || !never) return give_back(taken), false;
    if (take(taken).kind != TokenKind::close_parenthesis) return give_back(taken), false;
    bool lone_sign = false;
    const Token token = drop_part(lone_sign);
    if (lone_sign) taken.push_back({TokenKind::nothing, 0, token.first, token.first, 0});
    taken.push_back(token);
    give_back(taken);
    return true;
}

Token TokenStream::drop_part(bool& lone_sign) {
    lexer_.be_quiet(true);
    passing_over_ = true;
    Token token = fetch();
    dropped_sign_ = is_sign(token.kind);
    bool sign = false;  // of the last token
    for (std::size_t open = 0; token.kind != TokenKind::end_of_file; token = fetch()) {
        const bool ends = token.kind == TokenKind::hash_end;
        if (open == 0 && (ends || divides_directive(token.kind))) break;
        if (opens_directive(token.kind)) ++open;
        if (ends) --open;
        lone_sign = is_sign(token.kind) && !sign;
        sign = is_sign(token.kind);
    }
    lexer_.be_quiet(false);
    passing_over_ = false;
    return token;
}

void TokenStream::pass_over_part() {
    bool lone_sign = false;
    give_back({drop_part(lone_sign)});
    dropped_sign_ = false;
}

bool TokenStream::keep_else() {
    Tokens taken;
    take_parentheses(taken);
    if (take(taken).kind != TokenKind::hash_else) return give_back(taken), false;
    Tokens part;
    Balance balance;
    for (;;) {
        const Token token = take(taken);
        if (token.kind == TokenKind::end_of_file || taken.size() > max_ahead ||
            (balance.directives() == 0 && divides_directive(token.kind)))
            return give_back(taken), false;
        if (balance.directives() == 0 && token.kind == TokenKind::hash_end) break;
        balance.add(token.kind);
        part.push_back(token);
    }
    give_back(balance.braces == 0 ? taken : part);
    return balance.braces != 0;
}

/// The value of `(version >= 3.1)` and other comparisons; nothing for other conditions.
std::optional<bool> TokenStream::version_condition(Tokens& taken) {
    if (take(taken).kind != TokenKind::open_parenthesis) return std::nullopt;
    const Token word = take(taken);
    if (word.kind != TokenKind::constant || NameId(word.value) != "version"_word)
        return std::nullopt;
    const TokenKind sign = take(taken).kind;
    const Token limit = take(taken);
    if (limit.kind != TokenKind::number || take(taken).kind != TokenKind::close_parenthesis)
        return std::nullopt;
    const double other = lexer_.number(limit);
    switch (sign) {
        case TokenKind::less:
            return version_ < other;
        case TokenKind::less_equal:
            return version_ <= other;
        case TokenKind::greater:
            return version_ > other;
        case TokenKind::greater_equal:
            return version_ >= other;
        case TokenKind::equal:
            return version_ == other;
        case TokenKind::not_equal:
            return version_ != other;
        default:
            return std::nullopt;
    }
}

bool TokenStream::choose_branch() {
    Tokens taken;
    const std::optional<bool> condition = version_condition(taken);
    std::vector<Tokens> branches(1);
    Balance balance;
    bool whole = true, plain = true;
    for (bool ended = !condition; !ended;) {
        const Token token = take(taken);
        const bool outside = balance.directives() == 0;
        ended = token.kind == TokenKind::end_of_file || taken.size() > max_ahead ||
                (outside && token.kind == TokenKind::hash_end);
        if (outside && (ended || divides_directive(token.kind))) {
            plain = plain && (ended || token.kind == TokenKind::hash_else);
            whole = whole && balance.braces == 0;
            balance = {};
            branches.emplace_back();
        } else {
            balance.add(token.kind);
            whole = whole && balance.braces >= 0;
            branches.back().push_back(token);
        }
    }
    plain = plain && branches.size() <= 3 && taken.back().kind == TokenKind::hash_end;
    if (!condition || !plain) return give_back(taken), false;
    const Token behind = take(taken);
    if (whole && behind.kind != TokenKind::open_brace) return give_back(taken), false;
    // The last list, for the tokens after #end, is empty.
    Tokens kept = branches[*condition ? 0 : 1];
    kept.push_back(behind);
    give_back(kept);
    return true;
}

bool TokenStream::take_branches(std::vector<Tokens>& branches, Tokens& taken, int braces) {
    branches.emplace_back();
    Balance balance;
    for (;;) {
        const Token token = take(taken);
        const bool ends = balance.directives() == 0 &&
                          (divides_directive(token.kind) || token.kind == TokenKind::hash_end);
        if (token.kind == TokenKind::end_of_file || taken.size() > max_ahead ||
            (ends && balance.braces != braces))
            return false;
        if (!ends) {
            balance.add(token.kind);
        } else if (token.kind == TokenKind::hash_end) {
            return true;
        } else {
            balance = {};
            branches.emplace_back();
        }
        branches.back().push_back(token);
    }
}

std::optional<std::vector<Token>> TokenStream::take_rest(Tokens& taken, int braces) {
    Tokens rest;
    Balance balance;
    if (braces == 0) {
        rest.push_back(take(taken));
        if (rest.back().kind != TokenKind::open_brace) return std::nullopt;
        braces = 1;
    }
    while (balance.braces > -braces || balance.directives() > 0) {
        const Token token = take(taken);
        const bool outside = balance.directives() == 0 &&
                             (divides_directive(token.kind) || token.kind == TokenKind::hash_end);
        if (token.kind == TokenKind::end_of_file || outside || taken.size() > max_ahead)
            return std::nullopt;
        balance.add(token.kind);
        rest.push_back(token);
    }
    return rest;
}

bool TokenStream::copy_rest_into_branches(const Token& divider, int braces) {
    Tokens taken, result;
    std::vector<Tokens> branches;
    const bool one = divider.kind == TokenKind::hash_else;
    const bool found =
        take_branches(branches, taken, braces) &&
        (one ? branches.size() == 1
             : branches.size() > 1 && branches.back().front().kind == TokenKind::hash_else);
    const Token end = found ? taken.back() : Token{};
    const auto ends_in_word = [](const Tokens& branch) {
        return !branch.empty() && is_block_word(branch.back().kind);
    };
    const bool fits = found && (braces > 0 || std::ranges::all_of(branches, ends_in_word));
    const std::optional<Tokens> rest = fits ? take_rest(taken, braces) : std::nullopt;
    if (!rest) return give_back(taken), false;
    result = *rest;
    result.push_back(divider);
    for (const Tokens& branch : branches) {
        result.insert(result.end(), branch.begin(), branch.end());
        result.insert(result.end(), rest->begin(), rest->end());
    }
    result.push_back(end);
    give_back(result);
    return true;
}

std::optional<TokenStream::Tokens> TokenStream::take_cases(Tokens& taken, int braces,
                                                           std::vector<std::size_t>& ends) {
    Tokens kept;
    Balance balance;
    bool broken = true;  // the tokens up to the next part follow a #break
    for (;;) {
        const Token token = take(taken);
        const bool outside = balance.directives() == 0;
        const bool last = outside && token.kind == TokenKind::hash_end;
        if (token.kind == TokenKind::end_of_file || taken.size() > max_ahead) return std::nullopt;
        if (last || (outside && divides_directive(token.kind))) {
            // A part without #break goes on in the next one.
            const bool open = balance.braces == braces && last;
            if (!broken && balance.braces != 0 && !open) return std::nullopt;
            if (!broken && open) ends.push_back(kept.size());
            balance = {};
            broken = false;
            kept.push_back(token);
            if (last) return kept;
        } else if (!broken && outside && token.kind == TokenKind::hash_break) {
            if (balance.braces != 0 && balance.braces != braces) return std::nullopt;
            if (balance.braces != 0) ends.push_back(kept.size());
            kept.push_back(token);
            broken = true;
        } else {
            balance.add(token.kind);
            if (!broken) kept.push_back(token);
        }
    }
}

bool TokenStream::copy_rest_into_cases(const Token& end, int braces) {
    Tokens taken;
    std::vector<std::size_t> ends;  // places in `kept` in front of which the rest comes
    std::optional<Tokens> kept = Tokens();
    if (end.kind != TokenKind::hash_end) kept = take_cases(taken, braces, ends);
    const std::optional<Tokens> rest = kept ? take_rest(taken, braces) : std::nullopt;
    if (!rest || rest->size() * (ends.size() + 1) > max_ahead) return give_back(taken), false;
    Tokens result = *rest;
    result.push_back(end);
    std::size_t from = 0;
    for (const std::size_t at : ends) {
        result.insert(result.end(), kept->begin() + static_cast<std::ptrdiff_t>(from),
                      kept->begin() + static_cast<std::ptrdiff_t>(at));
        result.insert(result.end(), rest->begin(), rest->end());
        from = at;
    }
    result.insert(result.end(), kept->begin() + static_cast<std::ptrdiff_t>(from), kept->end());
    give_back(result);
    return true;
}

bool TokenStream::take_parentheses(Tokens& taken) {
    int open = take(taken).kind == TokenKind::open_parenthesis;
    if (open == 0) return false;
    while (open > 0 && taken.size() <= max_ahead && taken.back().kind != TokenKind::end_of_file) {
        const TokenKind kind = take(taken).kind;
        open += kind == TokenKind::open_parenthesis    ? 1
                : kind == TokenKind::close_parenthesis ? -1
                                                       : 0;
    }
    return open == 0;
}

std::string TokenStream::take_condition(Tokens& taken, std::string_view text) {
    const std::size_t first = taken.size();
    take_parentheses(taken);
    return parenthesised(text.substr(taken[first].first));
}

bool TokenStream::goes_on_with_sign(bool or_is_empty) {
    if (dropped_sign_) return true;
    Tokens taken;
    const bool found = takes_sign(taken, or_is_empty);
    give_back(taken);
    return found;
}

bool TokenStream::takes_sign(Tokens& taken, bool or_is_empty) {
    using enum TokenKind;
    for (bool condition = true; !condition || take_parentheses(taken);) {
        const TokenKind kind = take(taken).kind;
        if (is_sign(kind)) return true;
        if (or_is_empty && kind == hash_end) return true;
        condition = kind != hash_else && kind != hash_declare && kind != hash_break;
        if (kind == hash_declare) {
            while (taken.back().kind != semicolon && taken.size() <= max_ahead &&
                   taken.back().kind != end_of_file)
                take(taken);
        } else if (!divides_directive(kind) && kind != hash_break &&
                   (!opens_directive(kind) || kind == hash_macro)) {
            return false;
        }
    }
    return false;
}

TokenKind TokenStream::behind_value() {
    Tokens taken;
    const TokenKind result = take_behind_value(taken);
    give_back(taken);
    return result;
}

TokenKind TokenStream::take_behind_value(Tokens& taken) {
    using enum TokenKind;
    for (std::size_t open = 1; open > 0;) {
        const TokenKind before = taken.empty() ? hash_if : taken.back().kind;
        const TokenKind kind = take(taken).kind;
        if (kind == open_brace || kind == end_of_file || taken.size() > longest_value)
            return end_of_file;
        if (opens_directive(kind)) ++open;
        const bool value = may_end_value(before) || before == hash_end || before == hash_break;
        if (kind == hash_end && --open == 0 && !value) return end_of_file;
    }
    return take(taken).kind;
}

bool TokenStream::repeat_without_braces(const Token& opener, const Token& end,
                                        std::string_view text, int braces) {
    const std::string condition = parenthesised(text.substr(opener.last));
    Tokens taken;
    Balance balance;
    for (;;) {
        const std::size_t here = taken.size();
        const Token token = take(taken);
        const bool outside = balance.directives() == 0;
        if (token.kind == TokenKind::end_of_file || taken.size() > max_ahead ||
            balance.braces < 0 ||
            (outside && (divides_directive(token.kind) || token.kind == TokenKind::hash_end)))
            return give_back(taken), false;
        if (outside && balance.braces == 0 && token.kind == TokenKind::hash_if) {
            const bool same = take_condition(taken, text) == condition;
            std::vector<Tokens> branches;
            if (same && take_branches(branches, taken, -braces) && branches.size() == 1) {
                const auto rest = taken.begin() + static_cast<std::ptrdiff_t>(here);
                Tokens result(taken.begin(), rest);
                result.insert(result.end(), branches[0].begin(), branches[0].end());
                result.push_back({TokenKind::hash_else, 0, end.first, end.last, 0});
                result.insert(result.end(), taken.begin(), rest);
                result.push_back(taken.back());
                give_back(result);
                return true;
            }
            // It is a part of the tokens between the two conditions.
            for (std::size_t i = here; i < taken.size(); ++i) balance.add(taken[i].kind);
        } else {
            balance.add(token.kind);
        }
    }
}

}  // namespace candelabra
