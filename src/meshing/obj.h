// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as OBJ files, which are text. Called for --export-mesh.
#pragma once

#include "shape/mesh.h"

#include <string>

namespace candelabra {

/// The file's content: a line for each corner and each face; corners are counted from 1, and their
/// numbers read back as they were. Corners that no face has are left out.
std::string obj(const Mesh&);

}  // namespace candelabra
