// SPDX-License-Identifier: GPL-3.0-or-later
// STL files, whose triangles have points of their own; those at one place become one.
#pragma once

#include "cgal/polyhedra.h"

#include <string_view>

namespace candelabra {

namespace polyhedra {

/// Returns what is wrong with the file's content, or an empty string. A file is read as binary when
/// it has the length that its count of triangles gives, otherwise as text.
std::string read_stl(std::string_view file, Polyhedron&);

}  // namespace polyhedra

}  // namespace candelabra
