// SPDX-License-Identifier: GPL-3.0-or-later
// Signs that the language does not have and that people type or paste nevertheless: what a word
// processor, another language or another keyboard makes of those that it has. The lexer reports
// them and reads what was meant.
#pragma once

#include <string_view>

struct ForeignSign {
    std::string_view sign;   ///< in UTF-8
    std::string_view what;   ///< "a typographic quote"
    std::string_view meant;  ///< the sign of the language; a blank for other spaces
};

/// The sign that the text begins with, or null.
const ForeignSign* foreign_sign(std::string_view text);
