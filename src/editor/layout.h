// SPDX-License-Identifier: GPL-3.0-or-later
// Lays out a scene in the canonical style, for `candelabra fmt` and for editors. Only blanks at
// both ends of lines and empty lines change, never the text between them: the tokens stay the same,
// and so do comments and strings that span several lines.
#pragma once

#include "editor/edited_file.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Returns the text indented by four blanks for each enclosing block or directive, with lists in
/// parentheses and vectors aligned below their first value, without trailing blanks, with at most
/// two consecutive empty lines and none at either end. Idempotent.
std::string laid_out(std::string_view text);

/// Replacement for a part of a text.
struct LaidOutPart {
    Part place;
    std::string text;
};

/// Lays out the lines that overlap the part, relative to the surrounding lines, which stay
/// unchanged. Idempotent. For all lines, the result is that of laid_out().
LaidOutPart laid_out_lines(std::string_view text, Part part);

}  // namespace candelabra
