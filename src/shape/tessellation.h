// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as triangles: for what works on meshes (exact boolean operations, files, points that are
// spread over a surface) and for luminaires that have no formula. One place for all shapes: those
// of flat, round and tubular form have triangles of their own, those that are made of triangles
// keep them, all other solids are marched over.
#pragma once

#include "base/function_ref.h"
#include "shape/built_shape.h"
#include "shape/composite.h"

namespace candelabra {

/// Triangles near the surface, counterclockwise as seen from outside in a right-handed space, with
/// their corners on it. Closed where the shape is a bounded solid. `cells` is how many cells lie
/// along the longest side of the shape's box, or half as many as there are sides around what is
/// round; solids thinner than a cell may be missed. Empty for flat polygons and for all that has no
/// end. Precondition: cells is at least 4.
Mesh tessellation(const BuiltShape&, int cells);

/// The surface of a solid that is known by its inside and lies within the box, by marching
/// tetrahedra. Closed, and no edge has more than two triangles.
Mesh marched(const Box&, FunctionRef<bool(const Vec3&)> inside, int cells);

/// Adds the triangles of another mesh, under a map (null: where they are). A map that mirrors keeps
/// their outside outside.
void append(const Mesh& part, const Transform*, Mesh& all);

/// The triangles of one leaf of a composite, in the space of the whole, as far as its surface is
/// seen there: a triangle that is cut is in as a whole or left out.
Mesh seen_tessellation(const Composite&, std::uint32_t leaf, int cells);
/// Those of all leaves.
Mesh seen_tessellation(const Composite&, int cells);

/// The seen surface where a triangle near it is, followed along the triangle's normal.
std::optional<Composite::Meeting> surface_near(const Composite&, const std::array<Vec3, 3>& corners,
                                               const Vec3& point, Composite::Wanted);

}  // namespace candelabra
