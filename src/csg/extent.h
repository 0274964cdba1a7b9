// SPDX-License-Identifier: GPL-3.0-or-later
// The bounding boxes that min_extent and max_extent tell: POV-Ray's own, which are looser than
// bounds() for some shapes and for what is turned. Scenes compute with them.
#pragma once

#include "scene/scene.h"

namespace candelabra {

/// POV-Ray's number for no end.
inline constexpr double no_end = 1e10;

/// The box of the object in its own space, from -no_end to no_end where it has no end.
Box extent(const Object&);
/// The same before it is moved and clipped.
Box own_extent(const Object&);

/// Where POV-Ray notices that a ray begins inside of the object: everywhere, but for what is
/// inverse and no plane only in the box of what it is the inverse of, though its inside goes on.
Box bounds_of_inside(const Object&);

/// Whether rays do without what bounds the object, so that all of it is seen even where that is too
/// small. POV-Ray removes the bounds of single shapes other than polynomials, and of unions that
/// have an end and are no larger than their bounds.
bool has_needless_bounds(const Object&);
/// The object without its bounds, but with its clipping.
Object without_bounds(const Object&);

}  // namespace candelabra
