// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/brackets.h"

#include "syntax/misindented.h"
#include "text/ascii.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <utility>

namespace candelabra {

namespace {

/// Limit of nested directives: some work at each grows with their number.
constexpr std::size_t deepest_directives = 10'000;

/// Kinds of tokens that need no matching: nearly all.
constexpr auto plain = [] {
    std::array<bool, 256> result{};
    for (std::size_t i = 0; i < result.size(); ++i) {
        const auto kind = static_cast<TokenKind>(i);
        result[i] = !opens(kind) && !closes(kind) && !divides_directive(kind) &&
                    kind != TokenKind::hash_break && kind != TokenKind::end_of_file;
    }
    return result;
}();

/// Kinds of tokens that may need a marker token in front of them: few.
constexpr auto may_be_marked = [] {
    std::array<bool, 256> result{};
    for (std::size_t i = 0; i < result.size(); ++i) {
        const auto kind = static_cast<TokenKind>(i);
        result[i] = is_sign(kind) || begins_directive(kind) || ends_part(kind);
    }
    return result;
}();

}  // namespace

Token Brackets::next() {
    skipped_ = false;
    Token token = take();
    if (may_be_marked[static_cast<std::size_t>(token.kind)] || hangs_) {
        if (const auto mark = mark_before(token)) {
            pending_.push_back(token);
            // The part ends in an operator: the error is reported where the part is computed.
            if (*mark == TokenKind::continues && closes(token.kind) && !ends_part(token.kind))
                pending_.push_back({TokenKind::nothing, 0, token.first, token.first, 0});
            token = {*mark, 0, token.first, token.first, 0};
        }
    }
    member_ = last_.kind == TokenKind::dot;
    // Not `return last_ = token`: reading back a value just written in parts is slow.
    last_ = token;
    return token;
}

/// The marker that tells the parser how a sign or a directive relates to the tokens before it.
std::optional<TokenKind> Brackets::mark_before(const Token& token) {
    using enum TokenKind;
    if (std::exchange(hangs_, false)) return continues;
    if (ends_part(token.kind)) return mark_before_end(token);
    if (is_sign(token.kind)) {
        // Nothing can be subtracted from a string, so a `-` after it is the sign of the next value.
        // Before the language had expressions, this held after any value: <0 -1 2>.
        const bool old = tokens_.version() < 1.5 && ends_operand() && in_elements();
        const bool begins_value = last_.kind == text || is_signed_word(last_);
        if (token.kind == minus && (old || (begins_value && in_braces()))) return comma;
        return !open_.empty() && begins_part(open_.back()) ? std::optional(joins) : std::nullopt;
    }
    if (has_parts(token.kind)) {
        Open& directive = open_.back();
        if (open_.size() > 1 && begins_part(open_[open_.size() - 2])) {
            directive.goes_on = true;
            return std::nullopt;
        }
        const TokenKind around =
            open_.size() > 1 ? open_[open_.size() - 2].token.kind : TokenKind::end_of_file;
        if (ends_operand() && tokens_.goes_on_with_sign(around == open_parenthesis)) {
            directive.goes_on = true;
            return goes_on;
        }
        const bool marked = last_.kind >= between;
        if (!marked && (gives_value() || ends_expression(token.kind))) return gives;
    } else if (in_parentheses() && ends_operand()) {
        const bool aside = token.kind == hash_declare || token.kind == hash_undef;
        if (aside || token.kind == hash_message) return goes_on;
    }
    if (token.kind == hash_declare && last_.kind == equal) return leads;
    return wants_operand(last_.kind) ? std::optional(between) : std::nullopt;
}

/// Whether the token is an unreserved word that takes a possibly negative value, in its own block.
bool Brackets::is_signed_word(const Token& token) const {
    if (token.kind != TokenKind::name || !in_braces()) return false;
    constexpr std::string_view blanks = " \t\r\n";
    std::string_view block = text_.substr(0, open_.back().token.first);
    block = block.substr(0, block.find_last_not_of(blanks) + 1);
    std::size_t length = 0;
    while (length < block.size() && in_name(block[block.size() - 1 - length])) ++length;
    block.remove_prefix(block.size() - length);
    if (!takes_sign(block, spelling(token))) return false;
    // Old scenes may begin a light source with a vector of such a name.
    const std::size_t inside = open_.back().token.last;
    const std::string_view ahead = text_.substr(inside, token.first - inside);
    return block != "light_source" || ahead.find_first_not_of(blanks) != ahead.npos;
}

/// Whether the directive that has just begun is the left operand of an operator, as in
/// `(#if (A) 1 #else 2 #end * 3)`.
bool Brackets::gives_value() {
    using enum TokenKind;
    const auto around = std::find_if(open_.rbegin() + 1, open_.rend(),
                                     [](const Open& o) { return !has_parts(o.token.kind); });
    // Outside of all brackets most directives hold parts of the scene.
    const bool outside = around == open_.rend();
    if (outside && last_.kind != less && last_.kind != comma) return false;
    const TokenKind kind = tokens_.behind_value();
    const bool compares = kind == less || kind == less_equal || kind == greater_equal ||
                          kind == equal || kind == not_equal || kind == both || kind == either ||
                          kind == question;
    return is_sign(kind) || kind == dot ||
           (compares && !outside && around->token.kind == open_parenthesis);
}

/// Whether a loop or #switch is the last operand:
/// `2 * #switch (A) #case (1) 5 #break #else 7 #end`.
bool Brackets::ends_expression(TokenKind loop) {
    using enum TokenKind;
    if (is_condition(loop) || !wants_operand(last_.kind)) return false;
    const TokenKind kind = tokens_.behind_value();
    return closes(kind) || kind == semicolon || kind == comma || kind == greater;
}

/// The marker before a token that ends a part of a condition. open_ is up to date for the token.
std::optional<TokenKind> Brackets::mark_before_end(const Token& token) {
    const bool whole = token.kind == TokenKind::hash_end;
    Open& directive = whole ? closed_ : open_.back();
    // `I++` is an error.
    const bool sign = is_sign(last_.kind) && last_.first > 0 && text_[last_.first - 1] != '+' &&
                      text_[last_.first - 1] != '-';
    const bool hangs = sign || last_.kind == TokenKind::continues;
    if (has_parts(directive.token.kind) && (hangs || last_.kind == TokenKind::nothing)) {
        directive.hangs = true;
        if (hangs) return TokenKind::nothing;
    }
    if (whole) hangs_ = directive.hangs;
    return std::nullopt;
}

/// Whether only include guards, `#ifndef (A)` or the #else of `#ifdef (A)`, are around the macro.
bool Brackets::may_define_open_macro() const {
    return std::ranges::none_of(open_, [](const Open& o) {
        const bool guard = o.token.kind == TokenKind::hash_ifdef &&
                           (o.token.value == 1 ? !o.divided : o.closed_to_else);
        return opens_directive(o.token.kind) && !guard;
    });
}

/// Whether a parenthesis here belongs to the head of a directive or of a case.
bool Brackets::begins_head() {
    using enum TokenKind;
    const TokenKind kind = last_.kind;
    if (kind == name && !open_.empty() && open_.back().token.kind == hash_macro)
        return !std::exchange(open_.back().divided, true);
    return has_parts(kind) || kind == hash_elseif || kind == hash_case || kind == hash_range;
}

/// Whether the last token ends an operand, so that a directive here may continue an expression.
bool Brackets::ends_operand() const {
    using enum TokenKind;
    const TokenKind kind = last_.kind;
    if (kind == close_parenthesis) return !closed_.head;
    if (member_) return true;
    return (may_end_value(kind) && kind != channel) || (kind == hash_end && closed_.goes_on);
}

/// Whether the next token begins a part of a directive that continues an expression, or follows
/// another directive there.
bool Brackets::begins_part(const Open& directive) const {
    using enum TokenKind;
    const TokenKind kind = last_.kind;
    return directive.goes_on && (kind == hash_else || kind == hash_end || kind == semicolon ||
                                 (kind == close_parenthesis && closed_.head));
}

Token Brackets::take() {
    if (pending_.empty()) return match();
    const Token first = pending_.back();
    pending_.pop_back();
    return first;
}

/// Returns the next token of the text, with open_ brought up to date for it. Tokens that must
/// precede it are put into pending_ with it.
Token Brackets::match() {
    if (ended_) return *ended_;
    for (;;) {
        const Token token = tokens_.next();
        if (plain[static_cast<std::size_t>(token.kind)]) return token;
        if (token.kind == TokenKind::hash_macro && may_define_open_macro() &&
            tokens_.define_open_macro(token))
            continue;
        bool fits = true;
        if (opens_directive(token.kind) && directives_ == deepest_directives) {
            end_too_deep(token);
            return take();
        }
        if (opens(token.kind)) {
            directives_ += opens_directive(token.kind);
            const bool head = token.kind == TokenKind::open_parenthesis && begins_head();
            open_.push_back({token});
            open_.back().head = head;
            // The lexer has reported a directive without #, which may not be meant as one.
            open_.back().blamed = opens_directive(token.kind) && text_[token.first] != '#';
        } else if (closes(token.kind)) {
            fits = accept_closer(token);
        } else if (divides_directive(token.kind)) {
            fits = accept_else(token);
        } else if (token.kind == TokenKind::hash_break) {
            fits = accept_break(token);
        } else if (token.kind == TokenKind::end_of_file) {
            end_of_file(token);
        }
        if (fits) return pending_.empty() ? token : take();
    }
}

bool Brackets::accept_closer(const Token& closer) {
    std::size_t depth = open_.size();
    // Parentheses and square brackets do not match across the braces or the directive around them.
    const bool local =
        closer.kind == TokenKind::close_parenthesis || closer.kind == TokenKind::close_bracket;
    while (depth > 0 && closer_of(open_[depth - 1].token.kind) != closer.kind) {
        const TokenKind between = open_[depth - 1].token.kind;
        // Nor do braces across a directive, if a brace from a branch was already closed there.
        const bool paid =
            closer.kind == TokenKind::close_brace && opens_directive(between) && spare_braces_ > 0;
        if (paid || (local && (between == TokenKind::open_brace || opens_directive(between)))) {
            depth = 0;
            break;
        }
        --depth;
    }
    if (depth > 0) {
        if (closer.kind == TokenKind::hash_end &&
            (goes_on_unbraced(depth, closer) || closes_behind_cases(depth, closer)))
            return false;
        close_until(depth, closer);
        closed_ = open_.back();
        pop();
        return true;
    }
    int& spare = closer.kind == TokenKind::hash_end ? spare_ends_ : spare_braces_;
    if (!local && spare > 0) {
        --spare;
        return false;
    }
    Diagnostic problem = error(Fault::syntax, span(closer),
                               message("`", spelling(closer), "` closes nothing that is open"));
    if (!open_.empty()) problem.pointing(span(open_.back().token), "the innermost that is open");
    if (!open_.empty() && open_.back().token.kind == TokenKind::hash_macro)
        problem.with_help(OpenMacros::unopened);
    if (!macros_.blame(closer)) diagnostics_.add(problem);
    return false;
}

bool Brackets::accept_else(const Token& divider) {
    std::size_t depth = open_.size();
    while (depth > 0 && !can_be_divided_by(open_[depth - 1].token.kind, divider.kind)) --depth;
    if (depth == 0) {
        const bool in_switch =
            divider.kind == TokenKind::hash_case || divider.kind == TokenKind::hash_range;
        diagnostics_.add(
            error(Fault::misplaced, span(divider),
                  message("`", spelling(divider), "` belongs between ",
                          in_switch ? "`#switch`" : "`#if`", " and its `#end`, and none is open")));
        return false;
    }
    if (continue_in_branches(depth, divider)) return false;
    close_until(depth, divider);
    Open& opener = open_.back();
    opener.divided = true;
    if (opener.closed_to_else) {
        diagnostics_.add(error(Fault::misplaced, span(divider),
                               message("`", spelling(divider), "` cannot follow `#else`"))
                             .pointing(span(opener.token), "of this directive"));
        return false;
    }
    opener.closed_to_else = divider.kind == TokenKind::hash_else;
    return true;
}

/// What follows a #break in its part of a loop or a #switch is never read. False if the tokens that
/// close the braces of the part come first.
bool Brackets::accept_break(const Token& token) {
    std::size_t depth = open_.size();
    while (depth > 0 && !opens_directive(open_[depth - 1].token.kind)) --depth;
    const TokenKind around = depth > 0 ? open_[depth - 1].token.kind : TokenKind::end_of_file;
    if (!has_parts(around) || is_condition(around)) return true;
    if (depth < open_.size()) return !closes_behind_cases(depth, token);
    tokens_.pass_over_part();
    return true;
}

/// Whether the parts of a #switch leave braces open that are closed behind its #end. If so, the
/// tokens that close them come next, and then the token at which the part ends.
bool Brackets::closes_behind_cases(std::size_t depth, const Token& end) {
    const std::size_t above = open_.size() - depth;
    return open_[depth - 1].token.kind == TokenKind::hash_switch && above > 0 &&
           only_braces_above(depth) && tokens_.copy_rest_into_cases(end, static_cast<int>(above));
}

/// Whether only braces are open above the given depth, with no error reported in any of them.
bool Brackets::only_braces_above(std::size_t depth) const {
    return std::all_of(
        open_.begin() + static_cast<std::ptrdiff_t>(depth), open_.end(),
        [](const Open& o) { return o.token.kind == TokenKind::open_brace && !o.blamed; });
}

/// Whether the first branch of a condition leaves braces open that are closed after its #end, or
/// ends in the word of a block whose braces follow there. If so, each branch gets a copy of the
/// rest.
bool Brackets::continue_in_branches(std::size_t depth, const Token& divider) {
    Open& opener = open_[depth - 1];
    const std::size_t above = open_.size() - depth;
    if (!is_condition(opener.token.kind) || opener.divided ||
        (above == 0 && !is_block_word(last_.kind)) || !only_braces_above(depth))
        return false;
    opener.divided = true;
    return tokens_.copy_rest_into_branches(divider, static_cast<int>(above));
}

/// Whether a condition without #else leaves braces open that another condition like it closes.
bool Brackets::goes_on_unbraced(std::size_t depth, const Token& end) {
    const Open& opener = open_[depth - 1];
    const std::size_t above = open_.size() - depth;
    if (opener.token.kind != TokenKind::hash_if || opener.divided || above == 0 ||
        !only_braces_above(depth))
        return false;
    return tokens_.repeat_without_braces(opener.token, end, text_, static_cast<int>(above));
}

/// Closes the brackets open above the given depth, before the closer. False if there are none.
bool Brackets::close_until(std::size_t depth, const Token& closer) {
    if (depth == open_.size()) return false;
    report_unclosed(closer, depth);
    pending_.push_back(closer);
    const std::size_t first = pending_.size();
    for (; open_.size() > depth; pop()) {
        const TokenKind kind = open_.back().token.kind;
        if (kind == TokenKind::open_brace) ++spare_braces_;
        if (opens_directive(kind)) ++spare_ends_;
        pending_.push_back({closer_of(kind), 0, closer.first, closer.first, 0});
    }
    std::reverse(pending_.begin() + static_cast<std::ptrdiff_t>(first), pending_.end());
    return true;
}

void Brackets::report_unclosed(const Token& closer, std::size_t depth) {
    if (std::any_of(open_.begin() + static_cast<std::ptrdiff_t>(depth), open_.end(),
                    [](const Open& o) { return o.blamed; }))
        return;
    const Token& opener = open_.back().token;
    if (macros_.blame(opener)) return;
    const bool branch = opener.kind == TokenKind::open_brace &&
                        (closer.kind == TokenKind::hash_end || divides_directive(closer.kind));
    const std::string_view opened = spelling(opener);
    Diagnostic problem =
        branch
            ? error(Fault::syntax, span(opener),
                    message("this `{` is not closed before `", spelling(closer), "`"))
            : error(Fault::syntax, span(closer),
                    message("`", spelling(closer), "` comes before the ",
                            opens_directive(opener.kind) ? "`#end`" : "end", " of `", opened, "`"));
    const bool macro = depth > 0 && open_[depth - 1].token.kind == TokenKind::hash_macro;
    if (branch) {
        problem
            .pointing(span(closer),
                      macro ? "the macro ends here" : "the part of the directive ends here")
            .with_help(macro ? OpenMacros::unclosed
                             : "what a part of a directive opens it must close itself");
    } else {
        problem.pointing(span(opener), "still open");
        problem.with_help(message("add the missing `",
                                  opens_directive(opener.kind) ? "#end"
                                  : opened == "("              ? ")"
                                  : opened == "["              ? "]"
                                                               : "}",
                                  "`"));
    }
    if (depth > 0) problem.pointing(span(open_[depth - 1].token), "what it belongs to");
    diagnostics_.add(problem);
}

/// Ends the text at a directive that is nested too deeply.
void Brackets::end_too_deep(const Token& token) {
    diagnostics_.add(error(Fault::recursion_limit, span(token),
                           message("more than ", deepest_directives,
                                   " directives are open here, which is the limit"))
                         .with_help("an #end may be missing after each of them; a long choice is "
                                    "written with #elseif or #switch"));
    open_.back().blamed = true;
    ended_ = {TokenKind::end_of_file, 0, token.first, token.first, 0};
    end_of_file(*ended_);
}

void Brackets::end_of_file(const Token& end) {
    if (open_.empty()) return;
    const Token opener = open_.back().token;
    if (!open_.back().blamed && !macros_.blame_all() && !macros_.blame(opener)) {
        const bool directive = opens_directive(opener.kind);
        Diagnostic problem =
            error(Fault::syntax, span(opener),
                  message("`", spelling(opener), "` has no ", directive ? "`#end`" : "end"));
        if (open_.size() > 1)
            problem.pointing(span(open_[open_.size() - 2].token), "open around it");
        if (const auto found = misindented(text_, directive)) {
            problem.pointing(span(found->opener), "perhaps this one is meant:");
            problem.pointing(span(found->closer),
                             message("this `", spelling(found->closer), "` stands further left"));
        }
        diagnostics_.add(problem);
    }
    pending_.push_back(end);
    const std::size_t first = pending_.size();
    for (; !open_.empty(); pop())
        pending_.push_back({closer_of(open_.back().token.kind), 0, end.first, end.first, 0});
    std::reverse(pending_.begin() + static_cast<std::ptrdiff_t>(first), pending_.end());
}

/// Whether an error inside `depth` brackets ends at this token, for which open_ is up to date.
bool Brackets::boundary(const Token& token, std::size_t depth) const {
    if (token.kind == TokenKind::end_of_file) return true;
    const bool in_elements = depth == 0 || open_.size() < depth ||
                             open_[depth - 1].token.kind == TokenKind::open_brace ||
                             opens_directive(open_[depth - 1].token.kind);
    if (closes(token.kind)) return open_.size() < depth;
    if (divides_directive(token.kind)) return open_.size() <= depth;
    if (!in_elements || !is_directive(token.kind)) return false;
    return open_.size() == depth + (opens(token.kind) ? 1 : 0);
}

void Brackets::recover(bool closer_missing) {
    const std::size_t depth =
        open_.size() - (opens(last_.kind) ? 1 : 0) + (closes(last_.kind) ? 1 : 0);
    skipped_ = false;
    if (last_.kind == TokenKind::end_of_file || closes(last_.kind) || boundary(last_, depth))
        return;
    skipped_ = true;
    if (depth > 0) open_[depth - 1].blamed = true;
    // Then its closer will be taken for that of the bracket around it.
    if (closer_missing && depth > 1) open_[depth - 2].blamed = true;
    Token token = take();
    while (!boundary(token, depth)) token = take();
    pending_.push_back(token);
    // The skipped text has ended: a directive after it does not stand where a value is expected.
    last_ = {TokenKind::semicolon, 0, token.first, token.first, 0};
}

std::optional<Span> Brackets::innermost() const {
    if (open_.empty()) return std::nullopt;
    return span(open_.back().token);
}

}  // namespace candelabra
