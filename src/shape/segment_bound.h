// SPDX-License-Identifier: GPL-3.0-or-later
// A shape as something that follows a straight line: tells more than a box of long shapes that lie
// aslant. Called where the parts of shapes in cells need bounds, by the indices of the world and of
// composites.
#pragma once

#include "base/transform.h"
#include "shape/built_shape.h"

namespace candelabra {

/// Each point of the shape is no further from a point of the line than `reach`, on each axis.
struct Stick {
    Vec3 from, to;
    Vec3 reach;
};

/// Around what a shape has in a box, in its own coordinates, under a map if there is one.
Stick stick_around(const BuiltShape&, const Box&, const Transform*);

/// Bounds of the part of the shape in the cell; empty when it does not pass through it.
Box clipped_bounds(const Stick&, const Box& cell);

}  // namespace candelabra
