// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/open_macros.h"

#include "syntax/balance.h"
#include "text/message.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace {

using Tokens = OpenMacros::Tokens;

/// Names between a pair of parentheses, with or without commas; nothing when there is more.
std::optional<std::vector<NameId>> parameters(std::span<const Token> tokens) {
    std::vector<NameId> result;
    bool comma = true;
    for (const Token& token : tokens) {
        const bool name = token.kind == TokenKind::name;
        if (!name && token.kind != TokenKind::comma) return std::nullopt;
        // `optional A`, which a call may leave out.
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

/// The names that a text declares by #declare (0) or #local (1).
std::vector<NameId> declared(const Tokens& body, std::uint32_t local) {
    std::vector<NameId> result;
    for (std::size_t i = 1; i < body.size(); ++i)
        if (body[i - 1].kind == TokenKind::hash_declare && body[i - 1].value == local &&
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
    if ((matches && !lacks_operand(body)) || !names) return by_name_.erase(name), false;
    by_name_[name] = macros_.size();
    macros_.push_back({name, macro.front(), macro.back(), balance.braces, *names, body});
    macros_.back().declared = declared(body, 0);
    macros_.back().locals = declared(body, 1);
    if (!matches) macros_.back().odd = odd_brace(body);
    return true;
}

OpenMacros::Macro* OpenMacros::find(NameId name) {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : &macros_[found->second];
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
    constexpr std::uint32_t local = 1;
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
        result.push_back(made(TokenKind::hash_declare, local));
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
    const bool opens = macro.odd.kind == TokenKind::open_brace;
    Diagnostic problem =
        error(Fault::syntax, span(macro.odd),
              opens ? "this `{` is not closed before `#end`" : "`}` closes nothing that is open");
    if (opens) problem.pointing(span(macro.end), "the macro ends here");
    problem
        .pointing(span(macro.opener), opens ? "what it belongs to" : "the innermost that is open")
        .with_help(opens ? unclosed : unopened);
    diagnostics_.add(problem);
}
