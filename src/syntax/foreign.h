// SPDX-License-Identifier: GPL-3.0-or-later
// Signs, directives and names that the language does not have and that people type or paste
// nevertheless: what a word processor, another language or another keyboard makes of those that it
// has. The lexer reports signs and directives and reads what was meant; names are for the
// evaluator's report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct ForeignSign {
    std::string_view sign;   ///< in UTF-8
    std::string_view what;   ///< "a typographic quote"
    std::string_view meant;  ///< the sign of the language; a blank for other spaces; empty: none
    bool needless = false;   ///< without it the text means the same
};

/// The sign that the text begins with, or null.
const ForeignSign* foreign_sign(std::string_view text);

/// The directive, without #, that is called by this word in other languages; empty: none.
std::string_view foreign_directive(std::string_view word);

/// What to write for a name that means something in other languages; empty: none.
std::string_view foreign_name(std::string_view name);

/// Words of blocks that other programs call by this one: it means different things in different
/// blocks.
std::vector<std::string_view> foreign_word(std::string_view word);

/// The way out where words of other languages are around the place that the parser stopped at:
/// signs for them, or what they lack; empty: there are none.
std::string_view foreign_words(std::string_view before, std::string_view after);

/// What to do without a `:` behind that text; empty: nobody knows.
std::string_view foreign_colon(std::string_view before);

/// A colour of six hexadecimal digits, as web pages have it, in the language; empty for other
/// words.
std::string hexadecimal_colour(std::string_view word);

}  // namespace candelabra
