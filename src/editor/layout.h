// SPDX-License-Identifier: GPL-3.0-or-later
// How a scene is laid out on lines: the program's own hand, for `candelabra fmt` and for editors.
// Only blanks at both ends of lines and empty lines change, never what stands between: the tokens
// of the text stay what they are, and so do comments and strings that run over several lines.
#pragma once

#include "editor/edited_file.h"

#include <string>
#include <string_view>

namespace candelabra {

/// The text with four blanks for each block or directive that a line lies in, lists in parentheses
/// and vectors below their first value, no blanks at the ends of lines, at most two empty lines
/// together and none at the ends of the text. Laying out the result again changes nothing.
std::string laid_out(std::string_view text);

/// New text for a part of a text.
struct LaidOutPart {
    Part place;
    std::string text;
};

/// The lines that the part has something of, laid out below what stands around them, which stays as
/// it is. Doing it again changes nothing. For all lines it is laid_out().
LaidOutPart laid_out_lines(std::string_view text, Part part);

}  // namespace candelabra
