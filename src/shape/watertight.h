// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a mesh encloses a space: then light that leaves the inner side of its faces stays inside.
#pragma once

#include "shape/mesh.h"

namespace candelabra {

enum class Closure {
    none,       ///< an edge belongs to an odd number of faces
    outwards,   ///< triangle_normal() of all faces points outwards
    inwards,    ///< inwards
    unoriented  ///< the windings of the faces do not agree
};

/// The mesh encloses a space if each edge belongs to an even number of faces. Corners in the same
/// place are one; faces without area do not count. Of several closed pieces, the larger ones tell
/// where all normals point.
Closure closure(const Mesh&);

/// That of the mesh if the windings of all faces are exchanged.
Closure turned_over(Closure);

}  // namespace candelabra
