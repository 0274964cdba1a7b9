// SPDX-License-Identifier: GPL-3.0-or-later
// Intersection of a ray with a surface, as the language gets it from single objects.
#pragma once

#include "base/vector.h"

namespace candelabra {

struct SurfaceHit {
    Vec3 position;
    Vec3 normal;  ///< unit; not flipped towards the ray's origin
};

}  // namespace candelabra
