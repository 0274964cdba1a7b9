// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that turn photometric quantities into the numbers of a scene, by the `photometry` of
// its global_settings, and the colours of light. The table in functions.cpp names and describes
// them.
#pragma once

#include "interpret/functions.h"

namespace candelabra {

Value light_of_lumens(FunctionCall&);
Value light_of_candela(FunctionCall&);
Value light_of_lux(FunctionCall&);
Value light_of_nits(FunctionCall&);
Value light_of_watts(FunctionCall&);
Value colour_of_kelvin(FunctionCall&);
Value colour_of_wavelength(FunctionCall&);

}  // namespace candelabra
