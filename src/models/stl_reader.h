// SPDX-License-Identifier: GPL-3.0-or-later
// STL files, whose triangles have separate points; coincident points are merged.
#pragma once

#include "models/polyhedron.h"

#include <string>
#include <string_view>

namespace candelabra {

namespace polyhedra {

/// Returns an error in the file's content, or an empty string. A file is read as binary when its
/// length matches its count of triangles, or when it is longer and does not begin with `solid`;
/// otherwise as text.
std::string read_stl(std::string_view file, Polyhedron&);

}  // namespace polyhedra

}  // namespace candelabra
