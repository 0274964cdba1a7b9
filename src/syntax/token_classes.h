// SPDX-License-Identifier: GPL-3.0-or-later
// Classes of token kinds, for code that reads tokens before the parser.
#pragma once

#include "syntax/token.h"

namespace candelabra {

/// Whether a block may begin with this kind, before its brace.
constexpr bool is_block_word(TokenKind kind) {
    return kind == TokenKind::word || kind == TokenKind::layer;
}

constexpr bool opens_directive(TokenKind kind) {
    using enum TokenKind;
    return kind == hash_if || kind == hash_ifdef || kind == hash_while || kind == hash_for ||
           kind == hash_switch || kind == hash_macro;
}

constexpr bool is_condition(TokenKind kind) {
    return kind == TokenKind::hash_if || kind == TokenKind::hash_ifdef;
}

/// Whether the kind splits an open directive into parts: #else, #elseif, #case, #range.
constexpr bool divides_directive(TokenKind kind) {
    using enum TokenKind;
    return kind == hash_else || kind == hash_elseif || kind == hash_case || kind == hash_range;
}

constexpr bool opens(TokenKind kind) {
    using enum TokenKind;
    return kind == open_brace || kind == open_parenthesis || kind == open_bracket ||
           opens_directive(kind);
}

constexpr bool closes(TokenKind kind) {
    using enum TokenKind;
    return kind == close_brace || kind == close_parenthesis || kind == close_bracket ||
           kind == hash_end;
}

constexpr bool is_directive(TokenKind kind) {
    return kind >= TokenKind::hash_declare && kind <= TokenKind::hash_write;
}

constexpr bool begins_directive(TokenKind kind) {
    using enum TokenKind;
    return is_directive(kind) && kind != hash_end && kind != hash_macro && !divides_directive(kind);
}

/// Whether the kind opens a directive whose parts are elements.
constexpr bool has_parts(TokenKind kind) {
    return opens_directive(kind) && kind != TokenKind::hash_macro;
}

/// Whether the kind ends a part of a condition.
constexpr bool ends_part(TokenKind kind) {
    using enum TokenKind;
    return kind == hash_else || kind == hash_elseif || kind == hash_end;
}

constexpr bool is_sign(TokenKind kind) {
    using enum TokenKind;
    return kind == plus || kind == minus || kind == times || kind == divide;
}

/// Whether a directive after this kind stands where a value is expected.
constexpr bool wants_operand(TokenKind before) {
    using enum TokenKind;
    return is_sign(before) || before == both || before == either || before == question ||
           before == colon || before == no || before == colour_prefix || before == hash_message ||
           before == continues;
}

/// Whether a value may end with this kind.
constexpr bool may_end_value(TokenKind kind) {
    using enum TokenKind;
    return kind == number || kind == literal || kind == name || kind == constant ||
           kind == close_parenthesis || kind == close_bracket || kind == greater || kind == channel;
}

/// Whether a value may begin with this kind. A `+` would join the value with the one before.
constexpr bool may_begin_value(TokenKind kind) {
    using enum TokenKind;
    return (kind >= name && kind <= text) || kind == open_parenthesis || kind == less ||
           kind == minus || kind == no;
}

constexpr TokenKind closer_of(TokenKind opener) {
    using enum TokenKind;
    if (opener == open_brace) return close_brace;
    if (opener == open_parenthesis) return close_parenthesis;
    if (opener == open_bracket) return close_bracket;
    return hash_end;
}

constexpr bool can_be_divided_by(TokenKind opener, TokenKind divider) {
    using enum TokenKind;
    if (divider == hash_else) return is_condition(opener) || opener == hash_switch;
    if (divider == hash_elseif) return is_condition(opener);
    return opener == hash_switch;
}

}  // namespace candelabra
