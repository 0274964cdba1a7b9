// SPDX-License-Identifier: GPL-3.0-or-later
// The boxes that POV-Ray keeps around single shapes; see extent.h. Some shapes are placed first and
// then get a box, most get a box which is placed.
#pragma once

#include "base/transform.h"
#include "shape/shape.h"

namespace candelabra {

/// The box around the shape where it is placed; null: where it was made.
Box shape_extent(const Shape&, const Transform* place);

}  // namespace candelabra
