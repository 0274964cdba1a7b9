// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a mesh encloses a space: then light that leaves the inner side of its faces stays inside.
#pragma once

#include "shape/mesh.h"

namespace candelabra {

/// Whether each edge belongs to an even number of faces. Corners in the same place are one; faces
/// without area do not count.
bool is_watertight(const Mesh&);

}  // namespace candelabra
