// SPDX-License-Identifier: GPL-3.0-or-later
// Converts objects of a scene to meshes, for `mesh { difference { ... } }` and --export-mesh.
// Shapes are triangulated; unions, intersections and differences of the triangles are exact.
#pragma once

#include "meshing/library.h"
#include "scene/scene.h"

namespace candelabra {

/// A closed mesh, or the reason why there is none, as a part of a sentence.
struct SolidMesh {
    Polyhedron polyhedron;
    std::string problem;
};

/// The object as a solid, with its transforms. Half spaces can only cut other solids. `cells`: see
/// tessellation(). Without the library (null), only single shapes can be converted.
SolidMesh solid_mesh(const Object&, int cells, const Polyhedra*);

/// The object's surface, open or closed: parts of unions separately, solids exactly where the
/// library can compute them, all others as the triangles whose centre is visible. Empty when the
/// object has no surface or is unbounded.
Mesh surface_mesh(const ObjectHandle&, int cells, const Polyhedra*);

}  // namespace candelabra
