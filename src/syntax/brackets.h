// SPDX-License-Identifier: GPL-3.0-or-later
// Stands between lexer and parser and sees to it that brackets and the words of directives match:
// `{ }`, `( )`, `[ ]`, and #if, #while, #for, #switch, #macro with #end. What does not match is
// reported once, with both places, and mended by closing what is open or by dropping what closes
// nothing; the parser never sees it. Only where each branch of a condition opens the same number of
// braces, or ends in a word whose braces follow, what comes behind its #end is part of every
// branch, up to where these are closed; and macros may open braces for each other.
#pragma once

#include "syntax/token_stream.h"

#include <optional>
#include <string_view>
#include <vector>

namespace candelabra {

class Brackets {
public:
    /// `version`: of the language, until the text names one.
    Brackets(Lexer& lexer, OpenMacros& macros, double version, SourceId source,
             std::string_view text, Diagnostics& diagnostics)
        : macros_(macros),
          tokens_(lexer, version, macros_),
          source_(source),
          text_(text),
          diagnostics_(diagnostics) {}

    Token next();
    /// Whether the next token comes behind a comma, right inside of braces.
    bool begins_item() const { return last_.kind == TokenKind::comma && in_braces(); }
    /// Gives a token back that next() gave last; `before` is the one before it.
    void put_back(const Token& token, const Token& before) {
        pending_.push_back(token);
        last_ = before;
    }

    /// After a syntax error at the token that next() gave last: goes on at the end of the innermost
    /// bracket or, in a list of elements, at the next directive. `closer_missing`: the bracket
    /// should have been closed before the error.
    void recover(bool closer_missing = false);
    /// Whether recover() left the token of the error behind.
    bool skipped() const { return skipped_; }

    /// The innermost bracket that is open, for messages.
    std::optional<Span> innermost() const;

private:
    struct Open {
        Token token;
        bool divided = false;         ///< its first part is over
        bool closed_to_else = false;  ///< an #else was there
        bool blamed = false;          ///< something in it has been reported
        bool head = false;            ///< a parenthesis with which a directive begins
        bool goes_on = false;         ///< a directive whose parts go on with an expression
        bool hangs = false;           ///< one of its parts ends in an operator
    };

    bool in_braces() const {
        return !open_.empty() && open_.back().token.kind == TokenKind::open_brace;
    }
    bool in_parentheses() const {
        return !open_.empty() && open_.back().token.kind == TokenKind::open_parenthesis &&
               !open_.back().head;
    }
    bool in_elements() const { return open_.empty() || in_braces(); }
    bool may_define_open_macro() const;
    Token take();
    Token match();
    std::optional<TokenKind> mark_before(const Token&);
    std::optional<TokenKind> mark_before_end(const Token&);
    bool begins_head();
    bool is_signed_word(const Token&) const;
    bool ends_operand() const;
    bool gives_value();
    bool ends_expression(TokenKind loop);
    bool begins_part(const Open& directive) const;
    bool accept_closer(const Token&);
    bool accept_else(const Token&);
    bool only_braces_above(std::size_t depth) const;
    bool continue_in_branches(std::size_t depth, const Token& divider);
    bool goes_on_unbraced(std::size_t depth, const Token& end);
    bool close_until(std::size_t depth, const Token& closer);
    void end_of_file(const Token&);
    void report_unclosed(const Token& closer, std::size_t depth);
    bool boundary(const Token&, std::size_t depth) const;

    Span span(const Token& token) const { return {source_, token.first, token.last}; }
    std::string_view spelling(const Token& token) const {
        return text_.substr(token.first, token.last - token.first);
    }

    OpenMacros& macros_;
    TokenStream tokens_;
    SourceId source_;
    std::string_view text_;
    Diagnostics& diagnostics_;
    std::vector<Open> open_;
    std::vector<Token> pending_;  ///< the next one last
    Token last_;
    bool member_ = false;  ///< the last token comes behind a dot
    /// How many `}` without partner are no news, because their `{` was closed in a branch.
    int spare_braces_ = 0;
    int spare_ends_ = 0;
    Open closed_;         ///< what was closed last
    bool hangs_ = false;  ///< what the last token closed
    bool skipped_ = false;
};

}  // namespace candelabra
