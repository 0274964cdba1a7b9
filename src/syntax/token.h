// SPDX-License-Identifier: GPL-3.0-or-later
// The tokens that grammar/tokens.re makes of a text and grammar/scene.yy reads. `#` and its word
// are one token. A token has a kind, a place, and a number whose meaning depends on the kind.
// Numbers and strings are stored in the tree under construction.
#pragma once

#include "vocabulary/words.h"

#include <cstdint>
#include <string_view>

namespace candelabra {

/// The order is that of the %token lines in grammar/scene.yy.
enum class TokenKind : std::uint8_t {
    end_of_file,
    // with a value
    name,
    word,
    layer,
    constant,
    unary_function,
    function,
    colour_prefix,
    channel,  // all up to here: NameId
    number,   // index in Tree::numbers
    literal,  // `<1, 2, 3>`: index of the first number; count is the number of components
    text,     // index in Tree::texts
    colour,
    array,
    function_literal,
    deprecated,
    once,
    unofficial,
    powers,         // xyz, before the powers of a term
    mixed,          // `array mixed`
    optional_list,  // `optional {`
    // directives
    hash_declare,  // value 1: #local
    hash_message,  // value: MessageKind
    hash_undef,
    hash_if,
    hash_ifdef,  // value 1: #ifndef
    hash_elseif,
    hash_else,
    hash_end,
    hash_while,
    hash_for,
    hash_switch,
    hash_case,
    hash_range,
    hash_break,
    hash_macro,
    hash_include,
    hash_default,
    hash_version,
    hash_fopen,
    hash_fclose,
    hash_read,
    hash_write,
    // signs
    open_brace,
    close_brace,
    open_parenthesis,
    close_parenthesis,
    open_bracket,
    close_bracket,
    less,
    greater,
    less_equal,
    greater_equal,
    equal,
    not_equal,
    both,
    either,
    question,
    colon,
    plus,
    minus,
    times,
    divide,
    no,
    dot,
    comma,
    semicolon,
    // inserted by Brackets, after all others
    between,    // before a directive that follows an operator
    goes_on,    // before a directive that continues the expression before it
    joins,      // before an operator at the beginning of a part of such a directive
    nothing,    // after an operator at the end of a part of a condition
    continues,  // after a condition with such a part: the other operand follows
    gives,      // before a directive that is the left operand of the operator after it
    leads,      // before declarations that precede a declared value
};

struct Token {
    TokenKind kind = TokenKind::end_of_file;
    std::uint8_t count = 0;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t value = 0;
};

/// The name of a kind, for dumps.
std::string_view name(TokenKind);

}  // namespace candelabra
