// SPDX-License-Identifier: GPL-3.0-or-later
// Removes unused corners from meshes for files.
#pragma once

#include "shape/mesh.h"

namespace candelabra {

/// The corners and faces of a mesh: corners in the order in which faces first use them, without
/// those that no face has.
Mesh with_used_corners(const Mesh&);

}  // namespace candelabra
