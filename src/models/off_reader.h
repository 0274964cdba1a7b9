// SPDX-License-Identifier: GPL-3.0-or-later
// OFF files in text form: shapes only, without the colours and normals that some also have.
#pragma once

#include "models/polyhedron.h"

#include <string>
#include <string_view>

namespace candelabra {

namespace polyhedra {

/// Returns an error in the file's content, or an empty string.
std::string read_off(std::string_view file, Polyhedron&);

}  // namespace polyhedra

}  // namespace candelabra
