// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that ask about a declared object. The table in functions.cpp names them and says what
// they do.
#pragma once

#include "evaluate/functions.h"

Value inside_object(FunctionCall&);
Value first_hit(FunctionCall&);
Value lower_extent(FunctionCall&);
Value upper_extent(FunctionCall&);
