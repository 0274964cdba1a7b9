// SPDX-License-Identifier: GPL-3.0-or-later
// Which of two surfaces in one place a ray meets: a glass that stands on a table touches it all
// over, and what is seen through its foot is the one or the other. Two are in one place when the
// ray meets them at the same distance to the last digit, as it does planes, boxes and the ends of
// what is round along the axes, where nothing has moved them but translate. Triangles and what is
// turned or scaled are met a rounding error away, and there rounding decides, as in POV-Ray.
#pragma once

#include "world/geometry.h"

namespace candelabra {

/// Whether the ray meets an item before another one that it meets at the same distance.
/// Precondition: neither is infinite. As in POV-Ray, the one whose box it enters first; of two that
/// it enters together, and of two that it begins in, the one with the lower number.
bool precedes(const Geometry&, std::uint32_t item, std::uint32_t other, const Ray&);

}  // namespace candelabra
