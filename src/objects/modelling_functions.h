// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that return arrays of points on surfaces or in planes. The table in
// object_functions.cpp names and describes them.
#pragma once

#include "interpret/functions.h"

namespace candelabra {

Value scatter(FunctionCall&);
Value delaunay(FunctionCall&);
Value voronoi(FunctionCall&);

}  // namespace candelabra
