// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that give arrays of places: on surfaces, in planes. The table in object_functions.cpp
// names them and says what they do.
#pragma once

#include "interpret/functions.h"

namespace candelabra {

Value scatter(FunctionCall&);
Value delaunay(FunctionCall&);
Value voronoi(FunctionCall&);

}  // namespace candelabra
