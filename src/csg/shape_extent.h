// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's bounding boxes of single shapes; see extent.h. Some shapes are transformed before the
// box is computed, but for most the box is transformed.
#pragma once

#include "base/transform.h"
#include "shape/shape.h"

namespace candelabra {

/// The box around the transformed shape; null: identity.
Box shape_extent(const Shape&, const Transform* place);

}  // namespace candelabra
