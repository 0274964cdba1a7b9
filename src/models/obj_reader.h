// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ files: points, normals and texture coordinates, and faces that reference one of each for
// every corner. Lines, curves, groups and materials are skipped. Called by model_file.cpp.
#pragma once

#include "models/polyhedron.h"

#include <string>
#include <string_view>

namespace candelabra {

namespace polyhedra {

/// Reads the text. Returns an error with its line, or an empty string. The indices of faces are not
/// checked.
std::string read_obj(std::string_view text, Polyhedron&, PolyhedronLook&);

}  // namespace polyhedra

}  // namespace candelabra
