// SPDX-License-Identifier: GPL-3.0-or-later
// A shape as something that follows a straight line: tells more than a box of long shapes that lie
// aslant. Called where the parts of shapes in cells need bounds, as by the index of the world.
#pragma once

#include "base/transform.h"
#include "shape/built_shape.h"

/// Each point of the shape is no further from a point of the line than `reach`, on each axis.
struct Stick {
    Vec3 from, to;
    Vec3 reach;
};

/// Around a shape that has bounds, under a map if there is one.
Stick stick_around(const BuiltShape&, const Transform*);

/// Bounds of the part of the shape in the cell; empty when it does not pass through it.
Box clipped_bounds(const Stick&, const Box& cell);
