// SPDX-License-Identifier: GPL-3.0-or-later
// The tokens of a text for Brackets, which may look ahead. It makes sense of conditions whose
// branches are no whole elements:
//
//     #if (Merge) merge { #else union { #end A B }
//     #if (Merge) merge #else union #end { A B }
//
// are read as if A B } or { A B } stood in both branches, and
//
//     #if (version >= 3.1) material { #end A #if (version >= 3.1) } #end
//
// as if only the branches for the language's version were there, and with any other condition that
// is written twice as `#if (A) merge { B } #else B #end`. What stands behind #if (0) and
// #if (false) may be anything. Calls of macros whose braces do not match are replaced by their
// text.
#pragma once

#include "syntax/lexer.h"
#include "syntax/open_macros.h"
#include "syntax/token_classes.h"

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

class TokenStream {
public:
    /// `version`: of the language, until the text names one.
    TokenStream(Lexer& lexer, double version, OpenMacros& macros)
        : lexer_(lexer), version_(version), macros_(macros) {}

    Token next();
    /// Of the language, here.
    double version() const { return version_; }

    /// To be called behind the first #else or #elseif of a condition whose first branch leaves so
    /// many braces open, or ends in a word when there are none. When every other branch does, too,
    /// and there is an #else, the tokens from #end to the last of the braces that close them, or
    /// the block in braces that follows, go into each branch; that of the first branch comes next,
    /// then the divider. Otherwise nothing changes, and it is false.
    bool copy_rest_into_branches(const Token& divider, int braces);

    /// To be called behind the #end of a condition without #else that leaves so many braces open.
    /// When another condition of the same text closes them, what is between them comes next with
    /// its braces, then as #else without them. Otherwise nothing changes, and it is false.
    bool repeat_without_braces(const Token& opener, const Token& end, std::string_view text,
                               int braces);

    /// To be called behind #macro: whether its braces do not match. Then it is defined, and what
    /// follows its #end comes next; otherwise nothing changes.
    bool define_open_macro(const Token& opener);

    /// To be called behind the word of a directive: whether its first part begins with a sign, not
    /// counting declarations; or, on demand, has nothing else in it.
    bool goes_on_with_sign(bool or_is_empty);
    /// The same: what stands behind its #end, when there is a value before #end and the directive
    /// is short enough to be one.
    TokenKind behind_value();

private:
    using Tokens = std::vector<Token>;

    /// Whether the tokens that follow are taken: branches behind the divider, and what is behind
    /// #end.
    bool take_branches(std::vector<Tokens>& branches, Tokens& taken, int braces);
    std::optional<Tokens> take_rest(Tokens& taken, int braces);
    /// Behind #if: the text of its condition in parentheses, without blanks.
    std::string take_condition(Tokens& taken, std::string_view text);
    Token fetch();
    Token take(Tokens& taken);
    void give_back(const Tokens& taken);
    /// Behind a name, before which came a token of this kind: whether it and its arguments were a
    /// call of an open macro, whose text comes next.
    bool call(const Token& name, TokenKind before);
    /// Behind #if: keeps only the tokens of one branch, if the branches are no whole elements and
    /// the condition is about the version. Otherwise nothing changes, and it is false.
    bool choose_branch();
    std::optional<bool> version_condition(Tokens& taken);
    /// Behind #if: takes the tokens of a first branch away that is never read.
    bool drop_false_branch();
    /// Then: keeps only the tokens of its #else, if these are no whole elements. Otherwise nothing
    /// changes, and it is false.
    bool keep_else();
    bool takes_sign(Tokens& taken, bool or_is_empty);
    TokenKind take_behind_value(Tokens& taken);
    bool take_parentheses(Tokens& taken);

    Lexer& lexer_;
    double version_;
    OpenMacros& macros_;
    bool passing_over_ = false;   ///< what is read now stands behind #if (0)
    bool names_version_ = false;  ///< the last token was #version
    bool names_macro_ = false;    ///< the last token of the text was #macro
    bool dropped_sign_ = false;   ///< behind the last #if stood a sign, but is never read
    TokenKind before_ = TokenKind::end_of_file;  ///< the last token of the text
    std::deque<Token> ahead_;
};

}  // namespace candelabra
