// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that the binder adds to the language: queries of declared objects, and functions
// that return arrays of points.
#pragma once

#include "interpret/functions.h"

#include <span>
#include <vector>

namespace candelabra {

/// Sorted by name.
std::span<const FunctionInfo> object_functions();
/// These functions and those of the language, sorted by name, for help and editors.
std::vector<FunctionInfo> all_functions();

Value inside_object(FunctionCall&);
Value first_hit(FunctionCall&);
Value lower_extent(FunctionCall&);
Value upper_extent(FunctionCall&);

}  // namespace candelabra
