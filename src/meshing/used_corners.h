// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes for files, which have the corners that faces have and no others.
#pragma once

#include "shape/mesh.h"

namespace candelabra {

/// The corners and faces of a mesh; corners in the order in which the faces come to them, and those
/// that no face has left out.
Mesh with_used_corners(const Mesh&);

}  // namespace candelabra
