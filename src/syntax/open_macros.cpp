// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/open_macros.h"

#include "syntax/balance.h"
#include "text/message.h"

#include <algorithm>
#include <optional>

namespace candelabra {

namespace {

using Tokens = OpenMacros::Tokens;

/// Names between a pair of parentheses, separated by commas. Nothing if there are other tokens, as
/// in `optional A`, which a call may omit.
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

/// Arguments between a pair of parentheses, split at the commas outside of other brackets.
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
    // Braces that branches open and close again may all seem to match.
    return open.empty() ? body.front() : open.back();
}

/// The first parenthesis that closes nothing, or else the last that is not closed. Nothing if other
/// brackets of the text do not match.
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

/// The unmatched sign of `1, 2>` or `<1, 2,`, the end of a vector that begins elsewhere or the
/// beginning of one that ends elsewhere. `A < 2` is a comparison.
std::optional<Token> odd_angle(std::span<const Token> body) {
    using enum TokenKind;
    struct Begun {
        Token token;
        bool behind_value;  // then it may be a comparison
    };
    std::vector<Begun> begun;  // open `<` and other brackets
    const auto in_angle = [&] { return !begun.empty() && begun.back().token.kind == less; };
    for (std::size_t i = 0; i < body.size(); ++i) {
        const TokenKind kind = body[i].kind;
        if (kind == less || opens(kind)) {
            begun.push_back({body[i], i > 0 && may_end_value(body[i - 1].kind)});
        } else if (kind == greater) {
            const bool compares = i + 1 < body.size() && may_begin_value(body[i + 1].kind);
            if (!in_angle() && !compares) return body[i];
            if (in_angle()) begun.pop_back();
        } else if (closes(kind)) {
            for (; in_angle(); begun.pop_back())
                if (!begun.back().behind_value) return begun.back().token;
            if (!begun.empty()) begun.pop_back();
        }
    }
    return in_angle() && !begun.back().behind_value ? std::optional(begun.back().token)
                                                    : std::nullopt;
}

/// Whether an operator lacks an operand, as in `* 2`, `2 +`, `#if (A) - #end`.
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

/// Values of the token hash_declare.
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

/// Copies the numbers and strings of tokens from one tree to another, and updates the tokens.
void move_values(Tokens& tokens, const Tree& from, Tree& to) {
    for (Token& token : tokens) {
        const std::uint32_t old = token.value;
        if (token.kind == TokenKind::number || token.kind == TokenKind::literal) {
            token.value = static_cast<std::uint32_t>(to.numbers.size());
            const std::uint32_t count = token.kind == TokenKind::number ? 1 : token.count;
            for (std::uint32_t i = 0; i < count; ++i) to.numbers.push_back(from.numbers[old + i]);
        } else if (token.kind == TokenKind::text) {
            token.value = static_cast<std::uint32_t>(to.texts.size());
            to.texts.push_back(from.texts[old]);
            if (std::ranges::binary_search(from.verbatim, old)) to.verbatim.push_back(token.value);
        }
    }
}

/// The place of a token of the macro's text.
Span place(const OpenMacro& macro, const Token& token) {
    return {macro.values.source, token.first, token.last};
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
    const auto names = candelabra::parameters({macro.begin() + head, closer});
    const Tokens body(closer + 1, macro.end() - 1);
    const bool matches = balance.braces == 0 && least == 0;
    std::optional<Token> odd = matches ? odd_parenthesis(body) : odd_brace(body);
    if (!odd) odd = odd_angle(body);
    const bool closed = !odd && !lacks_operand(body);
    const bool sign = closed && !body.empty() && is_sign(body.front().kind);
    const auto before = by_name_.find(name);
    const bool called = before != by_name_.end() && macros_[before->second].shared->called;
    forget(name);
    if (closed && !sign) closed_.try_emplace(name, macro.front().first);
    if ((closed && !sign) || !names) return false;
    auto shared = std::make_shared<OpenMacro>(
        OpenMacro{name, macro.front(), macro.back(), balance.braces, *names, body});
    shared->values.source = tree_.source;
    move_values(shared->body, tree_, shared->values);
    shared->declared = declared(body, Declares::globals);
    shared->locals = declared(body, Declares::locals);
    shared->odd = odd.value_or(Token{});
    shared->continues = sign;
    shared->called = called;
    known_.push_back(shared);
    learn(shared);
    return !sign;
}

void OpenMacros::include(const Token& file, double version) {
    if (!reader_) return;
    reader_(std::string(tree_.texts[file.value]), span(file), version, known_);
    learn_known();
}

void OpenMacros::learn_known() {
    by_name_.clear();
    for (const auto& each : known_) learn(each);
}

void OpenMacros::learn(const std::shared_ptr<OpenMacro>& macro) {
    const auto found = std::ranges::find(macros_, macro, &Macro::shared);
    by_name_[macro->name] = static_cast<std::size_t>(found - macros_.begin());
    if (found != macros_.end()) return;
    macros_.push_back({macro, macro->body});
    move_values(macros_.back().body, macro->values, tree_);
}

void OpenMacros::forget(NameId name) {
    by_name_.erase(name);
    std::erase_if(known_, [&](const auto& each) { return each->name == name; });
}

OpenMacros::Macro* OpenMacros::find(NameId name, TokenKind before) {
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) return nullptr;
    Macro& macro = macros_[found->second];
    return macro.shared->continues && !may_end_value(before) ? nullptr : &macro;
}

Tokens OpenMacros::expand(Macro& called, const Token& call, std::span<const Token> parenthesised) {
    OpenMacro& macro = *called.shared;
    called.calls.push_back(call.first);
    macro.called |= !is_own(macro);
    const auto values = arguments(parenthesised.subspan(1, parenthesised.size() - 2));
    if (const std::size_t most = macro.parameters.size(); values.size() != most) {
        diagnostics_.add(error(Fault::wrong_count, span(call),
                               message("macro `", names_.spelling(macro.name), "` takes ", most,
                                       most == 1 ? " argument" : " arguments", ", but here ",
                                       values.size() == 1 ? "is " : "are ", values.size()))
                             .pointing(place(macro, macro.opener), "defined here"));
    }
    Tokens result;
    const Instead instead = bind(macro, call, values, result);
    for (Token token : called.body) {
        // A token's place must be in this file.
        if (!is_own(macro)) token.first = call.first, token.last = call.last;
        const auto other =
            token.kind == TokenKind::name ? instead.find(NameId(token.value)) : instead.end();
        if (other == instead.end()) {
            result.push_back(token);
        } else if (other->second.size() > 1) {
            result.insert(result.end(), other->second.begin(), other->second.end());
        } else {
            const Token& one = other->second.front();
            result.push_back({one.kind, one.count, token.first, token.last, one.value});
        }
    }
    return result;
}

OpenMacros::Instead OpenMacros::bind(const OpenMacro& macro, const Token& call,
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
    for (const NameId name : macro.locals) instead[name] = {own_name(name)};
    for (std::size_t i = 0; i < std::min(values.size(), macro.parameters.size()); ++i) {
        const NameId parameter = macro.parameters[i];
        const std::span<const Token> value = values[i];
        const bool changed =
            contains(macro.declared, parameter) || contains(macro.locals, parameter);
        if (value.size() == 1 && (value[0].kind == TokenKind::name || !changed)) {
            instead[parameter] = {value[0]};
            continue;
        }
        if (!changed && may_stand_in_parentheses(value, macro, parameter)) {
            Tokens& all = instead[parameter];
            all.push_back(made(TokenKind::open_parenthesis, 0));
            all.insert(all.end(), value.begin(), value.end());
            all.push_back(made(TokenKind::close_parenthesis, 0));
            continue;
        }
        const Token own = own_name(parameter);
        instead[parameter] = {own};
        result.push_back(made(TokenKind::hash_declare, std::uint32_t(Declares::locals)));
        result.push_back(own);
        result.push_back(made(TokenKind::equal, 0));
        result.insert(result.end(), value.begin(), value.end());
        result.push_back(made(TokenKind::semicolon, 0));
    }
    return instead;
}

/// Whether an argument may replace its parameter in parentheses. A declaration in front would end
/// the value before it: 2 #local A = 3; - A.
bool OpenMacros::may_stand_in_parentheses(std::span<const Token> value, const OpenMacro& macro,
                                          NameId parameter) const {
    const auto is_parameter = [&](const Token& t) {
        return t.kind == TokenKind::name && NameId(t.value) == parameter;
    };
    const auto is_no_number = [](const Token& t) {
        return t.kind == TokenKind::text || t.kind == TokenKind::open_brace;
    };
    return macro.continues && !value.empty() && std::ranges::none_of(value, is_no_number) &&
           std::ranges::count_if(macro.body, is_parameter) == 1;
}

bool OpenMacros::blame(const Token& token) {
    const auto found = std::ranges::find_if(macros_, [&](const Macro& each) {
        const OpenMacro& macro = *each.shared;
        return is_own(macro) ? macro.opener.first <= token.first && token.first < macro.end.first
                             : std::ranges::find(each.calls, token.first) != each.calls.end();
    });
    if (found == macros_.end() || found->shared->odd.kind == TokenKind::end_of_file) return false;
    report(*found->shared);
    return true;
}

bool OpenMacros::blame_all() {
    const auto left_by = [](const Macro& each) {
        return static_cast<long>(each.calls.size()) * each.shared->braces;
    };
    long left = 0;
    for (const Macro& each : macros_) left += left_by(each);
    if (left <= 0) return false;
    bool reported = false;
    for (const Macro& each : macros_)
        if (left_by(each) > 0) reported |= report(*each.shared);
    return reported;
}

bool OpenMacros::called_too_early() const {
    const auto is_own_call = [&](const Node& node) {
        const auto* call = std::get_if<node::Call>(&node.content);
        const auto found = call ? by_name_.find(call->name) : by_name_.end();
        if (found == by_name_.end()) return false;
        const OpenMacro& macro = *macros_[found->second].shared;
        const auto closed = closed_.find(macro.name);
        return is_own(macro) && !macro.continues &&
               (closed == closed_.end() || node.first < closed->second);
    };
    return !by_name_.empty() && std::ranges::any_of(tree_.nodes, is_own_call);
}

void OpenMacros::report_idle() {
    // A macro known from the previous parse may have been called before its definition.
    const auto is_called = [&](NameId name) {
        return std::ranges::any_of(macros_, [&](const Macro& each) {
            return each.shared->name == name && (each.shared->called || !each.calls.empty());
        });
    };
    for (const Macro& each : macros_)
        if (is_own(*each.shared) && !is_called(each.shared->name) &&
            each.shared->odd.kind != TokenKind::end_of_file)
            report(*each.shared);
}

bool OpenMacros::report(const OpenMacro& macro) {
    const Span odd = place(macro, macro.odd);
    if (std::ranges::find(told_, odd) != told_.end()) return false;
    told_.push_back(odd);
    using enum TokenKind;
    const TokenKind kind = macro.odd.kind;
    const bool opens = kind == open_brace || kind == open_parenthesis || kind == less;
    const bool angle = kind == less || kind == greater;
    const bool brace = !angle && kind != open_parenthesis && kind != close_parenthesis;
    const char sign = (brace ? "{}" : angle ? "<>" : "()")[opens ? 0 : 1];
    Diagnostic problem = error(Fault::syntax, odd,
                               opens ? message("this `", sign, "` is not closed before `#end`")
                                     : message("`", sign, "` closes nothing that is open"));
    if (opens) problem.pointing(place(macro, macro.end), "the macro ends here");
    problem.pointing(place(macro, macro.opener),
                     opens ? "what it belongs to" : "the innermost that is open");
    if (brace)
        problem.with_help(opens ? unclosed : unopened);
    else if (opens)
        problem.with_help(
            message("add the missing `", angle ? '>' : ')', "`, or let another macro close it"));
    else
        problem.with_help("leave it out, or let another macro open it");
    diagnostics_.add(problem);
    return true;
}

}  // namespace candelabra
