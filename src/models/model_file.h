// SPDX-License-Identifier: GPL-3.0-or-later
// Files of models: the triangles of OBJ, PLY, STL and OFF files. The readers are own code, because
// such files come from strangers, and a wrong one must end in a message. Called by meshing/.
#pragma once

#include "models/polyhedron.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Reads the triangles of a file, whose kind the name's extension decides; larger faces are
/// triangulated. Normals and texture coordinates are read from OBJ and PLY files. Returns an error
/// or, with a complete result, an empty string.
std::string read_model(std::string_view name, std::string_view bytes, Polyhedron&, PolyhedronLook&);

}  // namespace candelabra
