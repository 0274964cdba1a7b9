// SPDX-License-Identifier: GPL-3.0-or-later
// Objects of a scene as meshes: what `mesh { difference { ... } }` and --export-mesh make. Shapes
// are taken apart into triangles; unions, intersections and differences of them are then exact.
#pragma once

#include "meshing/library.h"
#include "scene/scene.h"

namespace candelabra {

/// A closed mesh, or why there is none, as a part of a sentence.
struct SolidMesh {
    Polyhedron polyhedron;
    std::string problem;
};

/// The solid that the object is, with its transforms. Half spaces serve to cut others. `cells`: see
/// tessellation(). Null: a single shape needs no library, others cannot be made then.
SolidMesh solid_mesh(const Object&, int cells, const Polyhedra*);

/// The object's surface, open or closed: parts of unions each for itself, solids exact where the
/// library can make them, all else of the triangles whose middle is seen. Empty when it has none,
/// or no end.
Mesh surface_mesh(const ObjectHandle&, int cells, const Polyhedra*);

}  // namespace candelabra
