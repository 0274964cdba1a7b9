// SPDX-License-Identifier: GPL-3.0-or-later
// The tokens of the language. re2c makes the scanner from this file; what a rule does with its
// text is in syntax/lexer.cpp.
#include "syntax/lexer.h"

namespace candelabra {

Token Lexer::scan() {
    using enum TokenKind;
    for (;;) {
        const char* const first = cursor_;
        /*!re2c
        re2c:api:style = free-form;
        re2c:define:YYCTYPE = "unsigned char";
        re2c:define:YYCURSOR = cursor_;
        re2c:define:YYMARKER = marker_;
        re2c:yyfill:enable = 0;

        digit    = [0-9];
        fraction = digit* "." digit+ | digit+ ".";
        exponent = [eE] [+-]? digit*;
        number   = (digit+ | fraction) exponent?;
        blank    = [ \t\r\n\v\f\x1a];
        signed   = [+-]? number;
        between  = blank* "," blank*;
        letter   = [A-Za-z_];

        // The text ends in a NUL that is not part of it; others are blanks.
        "\x00" {
            if (first < limit_) continue;
            cursor_ = limit_;
            return token(end_of_file, limit_);
        }
        blank+ { continue; }
        "//"   { skip_line_comment(); continue; }
        "/" "*"  { skip_comment(first); continue; }

        letter (letter | digit)*                { return read_word(first); }
        "#"                                     { return read_directive(first); }
        number                                  { return read_number(first); }
        fraction exponent? "." (digit | ".")+   {
            second_point(first);
            return read_number(first);
        }
        // A vector of nothing but numbers is one token: data files consist of them. So is that in
        // `f(a <1,2> b)`; comparisons beside each other are written (a < 1), (2 > b).
        "<" blank* signed (between signed){1,4} blank* ">" { return read_literal(first); }
        ["]                                     { return read_text(first); }

        "{"  { return token(open_brace, first); }
        "}"  { return token(close_brace, first); }
        "("  { return token(open_parenthesis, first); }
        ")"  { return token(close_parenthesis, first); }
        "["  { return token(open_bracket, first); }
        "]"  { return token(close_bracket, first); }
        "<"  { return token(less, first); }
        ">"  { return token(greater, first); }
        "<=" { return token(less_equal, first); }
        ">=" { return token(greater_equal, first); }
        "="  { return token(equal, first); }
        "!=" { return token(not_equal, first); }
        "&"  { return token(both, first); }
        "|"  { return token(either, first); }
        "?"  { return token(question, first); }
        ":"  { return token(colon, first); }
        "+"  { return token(plus, first); }
        "-"  { return token(minus, first); }
        "*"  { return token(times, first); }
        "/"  { return token(divide, first); }
        "!"  { return token(no, first); }
        "."  { return token(dot, first); }
        ","  { return token(comma, first); }
        ";"  { return token(semicolon, first); }

        // Signs of other languages: reported, then read as what was meant.
        "==" { double_sign(first, "="); return token(equal, first); }
        "&&" { double_sign(first, "&"); return token(both, first); }
        "||" { double_sign(first, "|"); return token(either, first); }
        *    {
            if (const auto meant = stray(first)) return *meant;
            continue;
        }
        */
    }
}

}  // namespace candelabra
