// SPDX-License-Identifier: GPL-3.0-or-later
// PLY files, as text or binary in either byte order: points, with normals and texture coordinates
// if present, and faces; other elements are skipped. Called by model_file.cpp.
#pragma once

#include "models/polyhedron.h"

#include <string>
#include <string_view>

namespace candelabra {

namespace polyhedra {

/// Reads the file. Returns an error, or an empty string. The indices of faces are not checked.
std::string read_ply(std::string_view file, Polyhedron&, PolyhedronLook&);

}  // namespace polyhedra

}  // namespace candelabra
