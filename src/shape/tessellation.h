// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulates shapes, for operations on meshes (exact boolean operations, files, points
// distributed over a surface) and for luminaires without a formula. All shapes are handled here:
// flat, round and tubular shapes have dedicated triangulations, shapes made of triangles keep them,
// and all other solids are marched.
#pragma once

#include "base/function_ref.h"
#include "shape/built_shape.h"
#include "shape/composite.h"

namespace candelabra {

/// Triangles that approximate the surface, counterclockwise seen from outside in a right-handed
/// space, with their corners on it. Closed where the shape is a bounded solid. `cells` is the
/// number of cells along the longest side of the shape's box, or half the number of sides around
/// round shapes; solids thinner than a cell may be missed. Empty for flat polygons and all
/// unbounded shapes. Precondition: cells is at least 4.
Mesh tessellation(const BuiltShape&, int cells);

/// Marching tetrahedra over a solid within the box, given by its inside test. The mesh is closed,
/// and no edge has more than two triangles.
Mesh marched(const Box&, FunctionRef<bool(const Vec3&)> inside, int cells);

/// Appends the triangles of another mesh, transformed by a map (null: identity). A map that mirrors
/// preserves their outside.
void append(const Mesh& part, const Transform*, Mesh& all);

/// The triangles of one leaf of a composite, in the space of the whole, where its surface is
/// visible there. A partly visible triangle is kept or dropped as a whole.
Mesh seen_tessellation(const Composite&, std::uint32_t leaf, int cells);
/// The triangles of all leaves.
Mesh seen_tessellation(const Composite&, int cells);

/// The visible surface near a point of a triangle, found along the triangle's normal.
std::optional<Composite::Meeting> surface_near(const Composite&, const std::array<Vec3, 3>& corners,
                                               const Vec3& point, Composite::Wanted);

}  // namespace candelabra
