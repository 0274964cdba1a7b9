// SPDX-License-Identifier: GPL-3.0-or-later
// Operations on meshes by the library of polyhedra, which is opened when first needed. Used by the
// evaluator's modelling blocks.
#pragma once

#include "cgal/polyhedra.h"
#include "shape/mesh.h"
#include "text/diagnostic.h"
#include "text/loader.h"

#include <optional>
#include <string>

namespace candelabra {

/// The entry points; null, with a diagnostic at the span, when the library cannot be opened.
const Polyhedra* modelling_library(Diagnostics&, Span asked_at);

/// The mesh's faces; coincident corners become one point. Normals and other attributes are dropped.
/// Precondition: problem(mesh) is empty.
Polyhedron polyhedron(const Mesh&);
/// A mesh with flat shading.
Mesh mesh(const Polyhedron&);
/// A mesh with smooth shading: each point's normal is the mean of those of the adjacent faces,
/// weighted by their angles there.
Mesh smooth_mesh(const Polyhedron&);

struct MeshFile {
    Polyhedron shape;
    PolyhedronLook look;
};
/// Reads an OBJ, PLY, STL or OFF file, whose kind its extension decides; empty, with a diagnostic
/// at the span, when it cannot be read.
std::optional<MeshFile> read_mesh_file(const Found&, Diagnostics&, Span asked_at);

/// Adds the texture coordinates of a file to its mesh, and the normals if the mesh has none.
/// Precondition: the mesh has the file's points and faces.
void dress(Mesh&, const PolyhedronLook&);

}  // namespace candelabra
