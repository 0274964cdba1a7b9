// SPDX-License-Identifier: GPL-3.0-or-later
// OFF files of text: shapes alone, without the colours and normals that some have besides.
#pragma once

#include "cgal/polyhedra.h"

#include <string_view>

namespace candelabra {

namespace polyhedra {

/// Returns what is wrong with the file's content, or an empty string.
std::string read_off(std::string_view file, Polyhedron&);

}  // namespace polyhedra

}  // namespace candelabra
