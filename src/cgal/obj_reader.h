// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ files: points, normals and places in pictures, and faces that name one of each for every
// corner. Lines, curves, groups and materials are passed over. Called by files.cpp.
#pragma once

#include "cgal/polyhedra.h"

#include <string_view>

namespace candelabra {

namespace polyhedra {

/// Reads the text; returns its fault with the line, or an empty string. That
/// faces name what is there remains to be checked.
std::string read_obj(std::string_view text, Polyhedron&, PolyhedronLook&);

}  // namespace polyhedra

}  // namespace candelabra
