// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that take or make strings. Strings are UTF-8 and lengths are in characters; a byte that
// is not UTF-8 counts as one. Their definitions are those of POV-Ray 3.7; functions.cpp names them.
#pragma once

#include "interpret/functions.h"

namespace candelabra {

/// Appends a number as C's %f does. `width`: at least so many characters, filled with blanks, or
/// with zeros if it is negative. `digits`: after the point; six if it is negative.
void append_formatted(std::string& text, double value, double width, double digits);

Value character(FunctionCall&);
Value character_number(FunctionCall&);
Value compare(FunctionCall&);
Value concatenated(FunctionCall&);
Value date_text(FunctionCall&);
Value first_code(FunctionCall&);
Value lower_case(FunctionCall&);
Value number_in(FunctionCall&);
Value number_text(FunctionCall&);
Value substring(FunctionCall&);
Value upper_case(FunctionCall&);
Value vector_text(FunctionCall&);

}  // namespace candelabra
