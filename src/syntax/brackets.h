// SPDX-License-Identifier: GPL-3.0-or-later
// A filter between the lexer and the parser that makes brackets and directives match: `{ }`, `( )`,
// `[ ]`, and #if, #while, #for, #switch, #macro with #end. A mismatch is reported once, with both
// places. It is repaired by closing the open bracket or by dropping the unmatched closer, so the
// parser never sees it. There are two exceptions. If each branch of a condition or a #switch opens
// the same number of braces, or ends in a word whose braces follow, the tokens after its #end up to
// the closing braces become part of every branch. And macros may open braces for each other. What
// follows a #break in its part of a loop or a #switch may be anything.
#pragma once

#include "syntax/token_stream.h"

#include <optional>
#include <string_view>
#include <vector>

namespace candelabra {

class Brackets {
public:
    /// `version`: language version until the text sets one.
    Brackets(Lexer& lexer, OpenMacros& macros, double version, SourceId source,
             std::string_view text, Diagnostics& diagnostics)
        : macros_(macros),
          tokens_(lexer, version, macros_),
          source_(source),
          text_(text),
          diagnostics_(diagnostics) {}

    Token next();
    /// Whether the next token follows a comma directly inside braces.
    bool begins_item() const { return last_.kind == TokenKind::comma && in_braces(); }
    /// Puts back the token that next() returned last. `before` is the token before it.
    void put_back(const Token& token, const Token& before) {
        pending_.push_back(token);
        last_ = before;
    }

    /// Recovers from a syntax error at the token that next() returned last: skips to the end of the
    /// innermost bracket or, in a list of elements, to the next directive. `closer_missing`: the
    /// bracket should have been closed before the error.
    void recover(bool closer_missing = false);
    /// Whether recover() skipped the token of the error.
    bool skipped() const { return skipped_; }

    /// The innermost open bracket, for messages.
    std::optional<Span> innermost() const;

private:
    struct Open {
        Token token;
        bool divided = false;         ///< its first part has ended
        bool closed_to_else = false;  ///< it has had an #else
        bool blamed = false;          ///< an error in it has been reported
        bool head = false;            ///< a parenthesis at the start of a directive
        bool goes_on = false;         ///< a directive whose parts continue an expression
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
    bool accept_break(const Token&);
    bool closes_behind_cases(std::size_t depth, const Token& end);
    bool only_braces_above(std::size_t depth) const;
    bool continue_in_branches(std::size_t depth, const Token& divider);
    bool goes_on_unbraced(std::size_t depth, const Token& end);
    bool close_until(std::size_t depth, const Token& closer);
    void end_too_deep(const Token&);
    void end_of_file(const Token&);
    void pop() {
        directives_ -= opens_directive(open_.back().token.kind);
        open_.pop_back();
    }
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
    std::size_t directives_ = 0;  ///< number of those in open_
    std::optional<Token> ended_;  ///< all that comes, where the text ends early
    std::vector<Token> pending_;  ///< in reverse: the next token is the last
    Token last_;
    bool member_ = false;  ///< the last token follows a dot
    /// Number of unmatched `}` not to report, because their `{` was closed in a branch.
    int spare_braces_ = 0;
    int spare_ends_ = 0;
    Open closed_;         ///< the bracket or directive closed last
    bool hangs_ = false;  ///< the last token closed a directive that hangs
    bool skipped_ = false;
};

}  // namespace candelabra
