// SPDX-License-Identifier: GPL-3.0-or-later
// PLY files, as text or as bytes of either order: points with normals and places in pictures as far
// as they have them, and faces; whatever else they hold is passed over. Called by files.cpp.
#pragma once

#include "cgal/polyhedra.h"

#include <string_view>

namespace candelabra {

namespace polyhedra {

/// Reads the file; returns its fault, or an empty string. That faces name what is
/// there remains to be checked.
std::string read_ply(std::string_view file, Polyhedron&, PolyhedronLook&);

}  // namespace polyhedra

}  // namespace candelabra
