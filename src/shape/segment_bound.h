// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds a shape by a thickened line segment, which is tighter than a box for long, slanted shapes.
// Called where the indices of the world and of composites need bounds of the part of a shape in a
// cell.
#pragma once

#include "base/transform.h"
#include "shape/built_shape.h"

namespace candelabra {

/// Every point of the shape is within `reach` of some point of the segment, on each axis.
struct Stick {
    Vec3 from, to;
    Vec3 reach;
};

/// Bounds the part of a shape in a box, given in the shape's coordinates, under an optional map.
Stick stick_around(const BuiltShape&, const Box&, const Transform*);

/// Bounds of the part of the shape in the cell; empty when it does not pass through it.
Box clipped_bounds(const Stick&, const Box& cell);

}  // namespace candelabra
