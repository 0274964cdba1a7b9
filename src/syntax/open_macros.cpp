// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/open_macros.h"

#include "syntax/balance.h"
#include "text/message.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace {

using Tokens = OpenMacros::Tokens;

/// Names between a pair of parentheses, divided by commas; nothing when there is more, such as
/// `optional A`, which a call may leave out.
std::optional<std::vector<NameId>> parameters(std::span<const Token> tokens) {
    std::vector<NameId> result;
    bool comma = true;
    for (const Token& token : tokens) {
        const bool name = token.kind == TokenKind::name;
        if (!name && token.kind != TokenKind::comma) return std::nullopt;
        if (name && !comma) return std::nullopt;
        comma = !name;
        if (name) result.push_back(NameId(token.value));
    }
    return result;
}

/// What is between a pair of parentheses, divided at the commas that are in no other brackets.
std::vector<std::span<const Token>> arguments(std::span<const Token> tokens) {
    using enum TokenKind;
    std::vector<std::span<const Token>> result;
    int open = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const TokenKind kind = tokens[i].kind;
        if (opens(kind) || kind == less) ++open;
        if (closes(kind) || kind == greater) --open;
        if (kind != comma || open > 0) continue;
        result.push_back(tokens.subspan(first, i - first));
        first = i + 1;
    }
    if (first < tokens.size()) result.push_back(tokens.subspan(first));
    return result;
}

/// The last brace that is not closed, or the first that closes nothing.
Token odd_brace(const Tokens& body) {
    std::vector<Token> open;
    for (const Token& token : body) {
        if (token.kind == TokenKind::open_brace) open.push_back(token);
        if (token.kind != TokenKind::close_brace) continue;
        if (open.empty()) return token;
        open.pop_back();
    }
    // What branches leave open and close again may look like nothing.
    return open.empty() ? body.front() : open.back();
}

/// The first parenthesis of a text that closes nothing, or the last that is not closed, where
/// nothing else is wrong with its brackets.
std::optional<Token> odd_parenthesis(std::span<const Token> body) {
    using enum TokenKind;
    std::vector<Token> open;
    std::optional<Token> first;
    for (const Token& token : body) {
        if (divides_directive(token.kind) &&
            (open.empty() || !can_be_divided_by(open.back().kind, token.kind)))
            return std::nullopt;
        if (opens(token.kind)) open.push_back(token);
        if (!closes(token.kind)) continue;
        if (!open.empty() && closer_of(open.back().kind) == token.kind) {
            open.pop_back();
        } else {
            if (!open.empty() || token.kind != close_parenthesis) return std::nullopt;
            if (!first) first = token;
        }
    }
    const auto is_parenthesis = [](const Token& t) { return t.kind == open_parenthesis; };
    if (!std::ranges::all_of(open, is_parenthesis)) return std::nullopt;
    return first || open.empty() ? first : open.back();
}

/// `* 2`, `2 +`, `#if (A) - #end`: an operator whose other operand is elsewhere.
bool lacks_operand(const Tokens& body) {
    if (body.empty()) return false;
    const TokenKind first = body.front().kind;
    if (first == TokenKind::times || first == TokenKind::divide || is_sign(body.back().kind))
        return true;
    const auto hangs = [](const Token& a, const Token& b) {
        return is_sign(a.kind) && ends_part(b.kind);
    };
    return std::ranges::adjacent_find(body, hangs) != body.end();
}

/// How the value of TokenKind::hash_declare says which of the two it is.
enum class Declares : std::uint32_t { globals = 0, locals = 1 };

/// The names that a text declares by #declare or by #local.
std::vector<NameId> declared(const Tokens& body, Declares which) {
    std::vector<NameId> result;
    for (std::size_t i = 1; i < body.size(); ++i)
        if (body[i - 1].kind == TokenKind::hash_declare && Declares(body[i - 1].value) == which &&
            body[i].kind == TokenKind::name)
            result.push_back(NameId(body[i].value));
    return result;
}

bool contains(const std::vector<NameId>& names, NameId name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

bool OpenMacros::define(const Tokens& macro) {
    constexpr std::size_t head = 3;  // #macro, its name and a parenthesis
    const auto closer = std::ranges::find(macro, TokenKind::close_parenthesis, &Token::kind);
    if (macro.size() < head || macro[1].kind != TokenKind::name ||
        macro[2].kind != TokenKind::open_parenthesis || closer == macro.end())
        return false;
    Balance balance;
    int least = 0;
    for (auto token = closer; token != macro.end() - 1; ++token) {
        balance.add(token->kind);
        least = std::min(least, balance.braces);
    }
    const NameId name{macro[1].value};
    const auto names = ::parameters({macro.begin() + head, closer});
    const Tokens body(closer + 1, macro.end() - 1);
    const bool matches = balance.braces == 0 && least == 0;
    const std::optional<Token> odd = matches ? odd_parenthesis(body) : odd_brace(body);
    const bool closed = !odd && !lacks_operand(body);
    const bool sign = closed && !body.empty() && is_sign(body.front().kind);
    if ((closed && !sign) || !names) return by_name_.erase(name), false;
    by_name_[name] = macros_.size();
    macros_.push_back({name, macro.front(), macro.back(), balance.braces, *names, body});
    macros_.back().declared = declared(body, Declares::globals);
    macros_.back().locals = declared(body, Declares::locals);
    macros_.back().odd = odd.value_or(Token{});
    macros_.back().continues = sign;
    return !sign;
}

OpenMacros::Macro* OpenMacros::find(NameId name, TokenKind before) {
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) return nullptr;
    Macro& macro = macros_[found->second];
    return macro.continues && !may_end_value(before) ? nullptr : &macro;
}

Tokens OpenMacros::expand(Macro& macro, const Token& call, std::span<const Token> parenthesised) {
    ++macro.calls;
    const auto values = arguments(parenthesised.subspan(1, parenthesised.size() - 2));
    if (const std::size_t most = macro.parameters.size(); values.size() != most) {
        diagnostics_.add(error(Fault::wrong_count, span(call),
                               message("macro `", names_.spelling(macro.name), "` takes ", most,
                                       most == 1 ? " argument" : " arguments", ", but here ",
                                       values.size() == 1 ? "is " : "are ", values.size()))
                             .pointing(span(macro.opener), "defined here"));
    }
    Tokens result;
    const Instead instead = bind(macro, call, values, result);
    for (Token token : macro.body) {
        const auto other =
            token.kind == TokenKind::name ? instead.find(NameId(token.value)) : instead.end();
        if (other == instead.end()) {
            result.push_back(token);
        } else {
            token.kind = other->second.kind;
            token.count = other->second.count;
            token.value = other->second.value;
            result.push_back(token);
        }
    }
    return result;
}

OpenMacros::Instead OpenMacros::bind(const Macro& macro, const Token& call,
                                     const std::vector<std::span<const Token>>& values,
                                     Tokens& result) {
    const auto made = [&](TokenKind kind, std::uint32_t value) {
        return Token{kind, 0, call.first, call.last, value};
    };
    Instead instead;
    const auto own_name = [&](NameId name) {
        const std::string own = message(names_.spelling(name), "_of_", names_.spelling(macro.name));
        return made(TokenKind::name, static_cast<std::uint32_t>(names_.intern(own)));
    };
    for (const NameId name : macro.locals) instead[name] = own_name(name);
    for (std::size_t i = 0; i < std::min(values.size(), macro.parameters.size()); ++i) {
        const NameId parameter = macro.parameters[i];
        const std::span<const Token> value = values[i];
        const bool changed =
            contains(macro.declared, parameter) || contains(macro.locals, parameter);
        if (value.size() == 1 && (value[0].kind == TokenKind::name || !changed)) {
            instead[parameter] = value[0];
            continue;
        }
        const Token own = own_name(parameter);
        instead[parameter] = own;
        result.push_back(made(TokenKind::hash_declare, std::uint32_t(Declares::locals)));
        result.push_back(own);
        result.push_back(made(TokenKind::equal, 0));
        result.insert(result.end(), value.begin(), value.end());
        result.push_back(made(TokenKind::semicolon, 0));
    }
    return instead;
}

bool OpenMacros::blame(const Token& token) {
    const auto found = std::ranges::find_if(macros_, [&](const Macro& macro) {
        return macro.opener.first <= token.first && token.first < macro.end.first;
    });
    if (found == macros_.end() || found->odd.kind == TokenKind::end_of_file) return false;
    return report(*found), true;
}

bool OpenMacros::blame_all() {
    long left = 0;
    for (const Macro& macro : macros_) left += long{macro.calls} * macro.braces;
    if (left <= 0) return false;
    for (Macro& macro : macros_)
        if (macro.calls > 0 && macro.braces > 0) report(macro);
    return true;
}

void OpenMacros::report_idle() {
    for (Macro& macro : macros_)
        if (macro.calls == 0 && macro.odd.kind != TokenKind::end_of_file) report(macro);
}

void OpenMacros::report(Macro& macro) {
    if (std::exchange(macro.told, true)) return;
    using enum TokenKind;
    const TokenKind kind = macro.odd.kind;
    const bool opens = kind == open_brace || kind == open_parenthesis;
    const bool brace = kind != open_parenthesis && kind != close_parenthesis;
    Diagnostic problem =
        error(Fault::syntax, span(macro.odd),
              opens ? message("this `", brace ? "{" : "(", "` is not closed before `#end`")
                    : message("`", brace ? "}" : ")", "` closes nothing that is open"));
    if (opens) problem.pointing(span(macro.end), "the macro ends here");
    problem
        .pointing(span(macro.opener), opens ? "what it belongs to" : "the innermost that is open")
        .with_help(brace   ? (opens ? unclosed : unopened)
                   : opens ? "add the missing `)`, or let another macro of this file close it"
                           : "leave it out, or let another macro of this file open it");
    diagnostics_.add(problem);
}
