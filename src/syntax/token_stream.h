// SPDX-License-Identifier: GPL-3.0-or-later
// The tokens of a text for Brackets, with lookahead. Interprets conditions whose branches are not
// whole elements:
//
//     #if (Merge) merge { #else union { #end A B }
//     #if (Merge) merge #else union #end { A B }
//
// are read as if A B } or { A B } stood in both branches.
//
//     #if (version >= 3.1) material { #end A #if (version >= 3.1) } #end
//
// is read as if only the branches for the language version were there. With any other condition
// written twice around B, it is read as `#if (A) merge { B } #else B #end`.
//
//     #switch (A) #case (0) merge { #break #else union { #end B }
//
// is read as if B } stood in each part, in front of #break. The text after #if (0) and #if (false)
// may be anything. Calls of open macros are replaced by their text.
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
    /// `version`: language version until the text sets one.
    TokenStream(Lexer& lexer, double version, OpenMacros& macros)
        : lexer_(lexer), version_(version), macros_(macros) {}

    Token next();
    /// The language version here.
    double version() const { return version_; }

    /// To be called after the first #else or #elseif of a condition whose first branch leaves
    /// `braces` braces open or, if that is 0, ends in a word. If every other branch does so too,
    /// and there is an #else, the tokens from #end to the last brace that closes them, or the block
    /// in braces that follows, are copied into each branch. The copy of the first branch comes
    /// next, then the divider. Otherwise changes nothing and returns false.
    bool copy_rest_into_branches(const Token& divider, int braces);

    /// To be called after the #end of a condition without #else that leaves `braces` braces open.
    /// If another condition of the same text closes them, the tokens between the two come next with
    /// the braces, then as #else without them. Otherwise changes nothing and returns false.
    bool repeat_without_braces(const Token& opener, const Token& end, std::string_view text,
                               int braces);

    /// To be called after a #break, or the #end, of a part of a #switch that leaves `braces` braces
    /// open. If the other parts do so too, the tokens from #end to the last brace that closes them
    /// are copied into each part, in front of its #break. The copy of this part comes next, then
    /// the token given. Otherwise changes nothing and returns false.
    bool copy_rest_into_cases(const Token& end, int braces);

    /// To be called after a #break: drops the tokens that follow it in its part of a directive,
    /// without reports.
    void pass_over_part();

    /// To be called after #macro. If the macro is open, it is defined, and the tokens after its
    /// #end come next. Otherwise changes nothing and returns false.
    bool define_open_macro(const Token& opener);

    /// To be called after the word of a directive: whether its first part begins with a sign, not
    /// counting declarations. `or_is_empty`: or has nothing else in it.
    bool goes_on_with_sign(bool or_is_empty);
    /// To be called there, too: the token kind after #end, if a value precedes #end and the
    /// directive is short enough to be a value; else end_of_file.
    TokenKind behind_value();

private:
    using Tokens = std::vector<Token>;

    /// Takes the branches after the divider, up to #end, or the tokens after #end that close their
    /// braces. Fails if the braces do not fit.
    bool take_branches(std::vector<Tokens>& branches, Tokens& taken, int braces);
    std::optional<Tokens> take_rest(Tokens& taken, int braces);
    /// After #if: takes its condition. Returns its text in parentheses, without blanks.
    std::string take_condition(Tokens& taken, std::string_view text);
    /// Takes the parts of a #switch up to its #end, without what follows a #break. Adds the rest to
    /// those that leave `braces` braces open. Nothing if a part leaves others open.
    std::optional<Tokens> take_cases(Tokens& taken, int braces, std::vector<std::size_t>& ends);
    /// Drops the tokens up to one that ends the part of the directive around, and returns that.
    Token drop_part(bool& lone_sign);
    Token fetch();
    Token take(Tokens& taken);
    void give_back(const Tokens& taken);
    /// After a name that follows a token of kind `before`: whether the name and its arguments are a
    /// call of an open macro. If so, the macro's text comes next.
    bool call(const Token& name, TokenKind before);
    /// After #if: keeps only the tokens of one branch, if the condition is on the version and the
    /// branches are not whole elements. Otherwise changes nothing and returns false.
    bool choose_branch();
    std::optional<bool> version_condition(Tokens& taken);
    /// After #if: drops the tokens of a first branch that is never read.
    bool drop_false_branch();
    /// After that: keeps only the tokens of its #else, if they are not whole elements. Otherwise
    /// changes nothing and returns false.
    bool keep_else();
    bool takes_sign(Tokens& taken, bool or_is_empty);
    TokenKind take_behind_value(Tokens& taken);
    bool take_parentheses(Tokens& taken);

    Lexer& lexer_;
    double version_;
    OpenMacros& macros_;
    bool passing_over_ = false;   ///< the text being read is in #if (0)
    bool names_version_ = false;  ///< the last token was #version
    bool names_macro_ = false;    ///< the last token of the text was #macro
    bool dropped_sign_ = false;   ///< the dropped branch of the last #if began with a sign
    TokenKind before_ = TokenKind::end_of_file;  ///< the last token of the text
    std::deque<Token> ahead_;
};

}  // namespace candelabra
