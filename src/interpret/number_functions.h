// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of numbers and vectors that take more than one call of the C++ library. Their
// definitions and limits are those of POV-Ray 3.7; functions.cpp names them.
#pragma once

#include "interpret/functions.h"

namespace candelabra {

Value arc_cosine(FunctionCall&);
Value arc_sine(FunctionCall&);
Value arc_tangent(FunctionCall&);
Value bits_and(FunctionCall&);
Value bits_or(FunctionCall&);
Value bits_xor(FunctionCall&);
Value cross_product(FunctionCall&);
Value decimal_logarithm(FunctionCall&);
Value divide_whole(FunctionCall&);
Value dot_product(FunctionCall&);
Value greatest(FunctionCall&);
Value least(FunctionCall&);
Value natural_logarithm(FunctionCall&);
Value new_random(FunctionCall&);
Value next_random(FunctionCall&);
Value normalised(FunctionCall&);
Value power(FunctionCall&);
Value remainder(FunctionCall&);
Value rotated(FunctionCall&);
Value rotated_about(FunctionCall&);
Value select(FunctionCall&);
Value square_root(FunctionCall&);
Value vector_length(FunctionCall&);
Value vector_turbulence(FunctionCall&);

/// Truncates to 32 bits, towards zero, as int() does.
double to_integer(double);

}  // namespace candelabra
