// SPDX-License-Identifier: GPL-3.0-or-later
// Writes meshes as PLY files, which all programs for meshes read. Called for --export-mesh.
#pragma once

#include "shape/mesh.h"

#include <string>

namespace candelabra {

/// The file's content: binary, little-endian, corners in double precision. Corners without a face
/// are left out.
std::string ply(const Mesh&);

}  // namespace candelabra
