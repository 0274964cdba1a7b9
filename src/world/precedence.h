// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which of two coincident surfaces a ray meets: a glass on a table touches it all over, and
// its foot shows the one or the other. Surfaces coincide when the ray meets them at the same
// distance to the last digit: planes, boxes and the flat ends of round shapes along the axes do so
// if they are only translated. Triangles, and rotated or scaled shapes, are a rounding error apart,
// and rounding decides, as in POV-Ray.
#pragma once

#include "world/geometry.h"

namespace candelabra {

/// Whether the ray meets an item before another one at the same distance. As in POV-Ray, this is
/// the item whose box it enters first; if it enters both together, or begins in both, the one with
/// the lower number. Precondition: both items are bounded.
bool precedes(const Geometry&, std::uint32_t item, std::uint32_t other, const Ray&);

}  // namespace candelabra
