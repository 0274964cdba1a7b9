// SPDX-License-Identifier: GPL-3.0-or-later
// Splits text into tokens, by the rules of grammar/tokens.re. It never fails: text that cannot be a
// token is reported and skipped. After the end of the text, all tokens are end_of_file.
#pragma once

#include "syntax/foreign.h"
#include "syntax/token.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"
#include "text/source.h"

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

class Lexer {
public:
    /// Numbers and strings are added to the tree, new names to `names`.
    /// `version`: language version until the text sets one.
    Lexer(SourceId, const SourceStore&, Names&, Tree&, Diagnostics&, double version = 3.7);

    Token next();
    /// Suppresses all reports while on: for text that is passed over.
    void be_quiet(bool on) { quiet_ = on; }
    /// The value of a number token.
    double number(const Token& token) const { return tree_.numbers[token.value]; }

private:
    Token token(TokenKind, const char* first, std::uint32_t value = 0);
    Token scan();
    void report(Diagnostic);
    Token read_word(const char* first);
    Token read_directive(const char* hash);
    Token read_unknown_directive(const char* hash, std::string_view spelling);
    bool takes_if(const char* hash);
    bool takes_comment();
    bool stands_behind_end(const char* first, std::string_view word);
    Token read_hexadecimal_colour(const char* hash, std::string_view word);
    bool is_asked_about() const;
    bool begins_version() const;
    void report_missing_hash(const char* first, std::string_view word);
    Token read_number(const char* first);
    Token read_literal(const char* first);
    Token read_text(const char* first);

    std::string_view rest() const { return {cursor_, static_cast<std::size_t>(limit_ - cursor_)}; }
    /// Skips blanks and comments; for use between # and its word.
    void skip_blanks();
    /// Skips a comment from just after its opening sign.
    void skip_line_comment();
    void skip_comment(const char* first);
    std::optional<Token> stray(const char* first);
    std::optional<Token> read_foreign_sign(const char* first, const ForeignSign&);
    Token read_foreign_word(const char* first);
    bool foreign_letter() const;
    /// Whether a value precedes the cursor and another can begin at it.
    bool between_values() const;
    void second_point(const char* first);
    void double_sign(const char* first, std::string_view instead);
    /// Whether a string here is the name of a file, whose backslashes are no escapes.
    bool verbatim_expected() const;
    bool goes_on_with(char sign) const;
    std::optional<Token> read_scoped_name(const char* first, std::string_view word);

    std::uint32_t offset(const char* p) const { return static_cast<std::uint32_t>(p - begin_); }
    Span span(const char* first, const char* last) const {
        return {source_, offset(first), offset(last)};
    }

    const char* begin_;
    const char* cursor_;
    const char* marker_ = nullptr;
    const char* limit_;
    SourceId source_;
    Names& names_;
    Tree& tree_;
    Diagnostics& diagnostics_;
    double version_;
    bool quiet_ = false;
    NameId last_word_ = no_name;
    std::optional<Span> long_string_;  ///< the first string that contains a line end
    TokenKind previous_ = TokenKind::end_of_file;
    TokenKind before_previous_ = TokenKind::end_of_file;
};

}  // namespace candelabra
