// SPDX-License-Identifier: GPL-3.0-or-later
// The normals of surfaces themselves. The crossings of smooth shapes have normals for shading,
// which may face away from where the surface faces.
#pragma once

#include "shape/composite.h"

#include <array>

namespace candelabra {

/// Unit normal of a smooth triangle itself, on its outer side: as in POV-Ray, the side to which the
/// normals of its corners point together. 0 if it has no area.
inline Vec3 outer_normal(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals) {
    const Vec3 own = triangle_normal(corners[0], corners[1], corners[2]);
    return dot(own, normals[0] + normals[1] + normals[2]) < 0 ? -own : own;
}

/// The outer unit normal of the flat face that a crossing of a shape belongs to; 0 for crossings
/// of shapes that are not made of such faces. `part`: see Crossing.
Vec3 face_normal(const BuiltShape&, std::uint32_t part);

/// The unit normal of the surface where a leaf was met, on the side of Meeting::normal. Smooth
/// height fields and fractals keep their normals for shading.
Vec3 surface_normal(const CompositeLeaf&, const Composite::Meeting&);

}  // namespace candelabra
