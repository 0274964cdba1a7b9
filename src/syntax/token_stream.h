// SPDX-License-Identifier: GPL-3.0-or-later
// The tokens of a text for Brackets, which may look ahead. It makes sense of conditions whose
// branches open a brace that the text behind them closes:
//
//     #if (Merge) merge { #else union { #end A B }
//
// is read as if A B } stood in both branches.
#pragma once

#include "syntax/lexer.h"

#include <deque>
#include <optional>
#include <vector>

class TokenStream {
public:
    explicit TokenStream(Lexer& lexer) : lexer_(lexer) {}

    Token next();

    /// To be called behind the first #else or #elseif of a condition whose first branch leaves so
    /// many braces open. When every other branch leaves as many, and there is an #else, the tokens
    /// from #end to the last of the braces that close them go into each branch; that of the first
    /// branch comes next, then the divider. Otherwise nothing changes, and it is false.
    bool copy_rest_into_branches(const Token& divider, int braces);

private:
    using Tokens = std::vector<Token>;

    /// Whether the tokens that follow are taken: branches behind the divider, and what is behind
    /// #end.
    bool take_branches(std::vector<Tokens>& branches, Tokens& taken, int braces);
    std::optional<Tokens> take_rest(Tokens& taken, int braces);
    Token take(Tokens& taken);

    Lexer& lexer_;
    std::deque<Token> ahead_;
};

constexpr bool opens_directive(TokenKind kind) {
    using enum TokenKind;
    return kind == hash_if || kind == hash_ifdef || kind == hash_while || kind == hash_for ||
           kind == hash_switch || kind == hash_macro;
}

/// Splits an open directive into parts: #else, #elseif, #case, #range.
constexpr bool divides_directive(TokenKind kind) {
    using enum TokenKind;
    return kind == hash_else || kind == hash_elseif || kind == hash_case || kind == hash_range;
}
