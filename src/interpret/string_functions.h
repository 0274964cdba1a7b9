// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of the language that take or make strings. Strings are UTF-8 and count in
// characters; a byte that is no UTF-8 counts as one. Their meanings are POV-Ray 3.7's;
// functions.cpp names them.
#pragma once

#include "interpret/functions.h"

namespace candelabra {

/// C's %f: so wide at least, filled with blanks, or with zeros when the width is below 0; so many
/// digits behind the point, six when that is below 0.
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
