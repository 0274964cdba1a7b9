// SPDX-License-Identifier: GPL-3.0-or-later
// Writes meshes as OBJ files, which are text. Called for --export-mesh.
#pragma once

#include "shape/mesh.h"

#include <string>

namespace candelabra {

/// The file's content: a line for each corner and each face. Corners are counted from 1, and their
/// coordinates round-trip exactly. Corners without a face are left out.
std::string obj(const Mesh&);

}  // namespace candelabra
