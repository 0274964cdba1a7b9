// SPDX-License-Identifier: GPL-3.0-or-later
// Signs, directives and names that the language lacks but people type or paste nevertheless: those
// of word processors, other languages and other keyboards. The lexer reports signs and directives
// and reads the intended ones in their place. Names are for the evaluator's report.
#pragma once

#include "text/span.h"

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct ForeignSign {
    std::string_view sign;   ///< in UTF-8
    std::string_view what;   ///< "a typographic quote"
    std::string_view meant;  ///< the language's sign; a blank for other spaces; empty: none
    bool needless = false;   ///< leaving it out does not change the meaning
};

/// The sign that the text begins with, or null.
const ForeignSign* foreign_sign(std::string_view text);

/// The directive, without #, that other languages call by this word; empty: none.
std::string_view foreign_directive(std::string_view word);

/// Help for a name that means something in other languages; empty: none.
std::string_view foreign_name(std::string_view name);

/// Words of blocks for which other programs use this word. Its meaning depends on the block.
std::vector<std::string_view> foreign_word(std::string_view word);

/// Help for words of other languages next to a syntax error: the signs to use for them, or what
/// they lack. Empty if there are none. `before` and `after` are the text around the error.
std::string_view foreign_words(std::string_view before, std::string_view after);

/// Help for a wrong `:` after this text; empty: none.
std::string_view foreign_colon(std::string_view before);

/// The language's expression for a colour of six hexadecimal digits, as web pages write it; empty
/// for other words.
std::string hexadecimal_colour(std::string_view word);

/// The name of a file that a name without quotes at this place is meant as, such as `sky.png`;
/// empty if it is not.
std::string meant_as_file(std::string_view text, Span name);

}  // namespace candelabra
