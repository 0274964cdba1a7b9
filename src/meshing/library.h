// SPDX-License-Identifier: GPL-3.0-or-later
// Work on meshes by the library of polyhedra, which is opened when it is first needed: what the
// evaluator's blocks of modelling are made with.
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

/// The mesh's faces; corners at the same place become one point. Normals and the like are left out.
/// Precondition: problem(mesh) is empty.
Polyhedron polyhedron(const Mesh&);
/// A flat mesh.
Mesh mesh(const Polyhedron&);
/// The same shaded as if it were curved, with the normals that its faces have around each point on
/// average, weighted by their angles.
Mesh smooth_mesh(const Polyhedron&);

struct MeshFile {
    Polyhedron shape;
    PolyhedronLook look;
};
/// What an OBJ, PLY, STL or OFF file says, which the end of its name tells apart; nothing, with a
/// diagnostic at the span, when it cannot be read.
std::optional<MeshFile> read_mesh_file(const Found&, Diagnostics&, Span asked_at);

/// Gives a mesh what a file says beyond its shape; normals only if it has none. Precondition: the
/// mesh has the file's points and faces.
void dress(Mesh&, const PolyhedronLook&);

}  // namespace candelabra
