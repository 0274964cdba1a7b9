// SPDX-License-Identifier: GPL-3.0-or-later
// The bounding boxes of min_extent and max_extent: POV-Ray's own, which are looser than bounds()
// for some shapes and for rotated objects. Scenes compute with them.
#pragma once

#include "scene/scene.h"

namespace candelabra {

/// POV-Ray's number for an infinite extent.
inline constexpr double no_end = 1e10;

/// The box of the transformed and clipped object, from -no_end to no_end where it is unbounded.
Box extent(const Object&);
/// The box before the object is transformed and clipped.
Box own_extent(const Object&);

/// Where POV-Ray notices that a ray begins inside of the object: in its box, although the inside of
/// an inverse object extends beyond it; everywhere for planes.
Box bounds_of_inside(const Object&);

/// Whether rays ignore the object's bounds, so that all of it is visible even where they are too
/// small. POV-Ray removes the bounds of single shapes other than polynomials, and of bounded unions
/// that are no larger than their bounds.
bool has_needless_bounds(const Object&);
/// The object without its bounds, but with its clipping.
Object without_bounds(const Object&);

}  // namespace candelabra
