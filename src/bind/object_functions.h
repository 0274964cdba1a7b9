// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that ask about a declared object, or make arrays of places: what the binder adds to the
// functions of the language.
#pragma once

#include "interpret/functions.h"

#include <span>
#include <vector>

namespace candelabra {

/// By name in order.
std::span<const FunctionInfo> object_functions();
/// These and those of the language, by name in order: for help and editors.
std::vector<FunctionInfo> all_functions();

Value inside_object(FunctionCall&);
Value first_hit(FunctionCall&);
Value lower_extent(FunctionCall&);
Value upper_extent(FunctionCall&);

}  // namespace candelabra
