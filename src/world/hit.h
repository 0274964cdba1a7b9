// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray of a world finds.
#pragma once

#include "base/short_list.h"
#include "world/geometry.h"

namespace candelabra {

/// Where a ray met a surface.
struct Hit {
    PrimitiveIndex primitive = no_primitive;
    std::uint32_t part = 0;  ///< of shapes and leaves: see Crossing
    Vec3 position = Vec3(0);
    Vec3 normal = Vec3(0);         ///< unit, outward: of the surface as it is
    Vec3 smooth_normal = Vec3(0);  ///< unit, outward: of the surface as it is shaded
    /// Rays that start here begin this far away, to miss the surface they come from.
    double tolerance = 0;
};

/// Who asks: some objects are left out for some rays.
enum class RayKind { camera, reflected, light, gathering };

/// The solids that a ray is in, by a primitive of each, in the order of entering.
using EnteredSolids = ShortList<PrimitiveIndex, 6>;

/// What a ray does to these where it passes a surface.
enum class Passing { enters, leaves_innermost, leaves_outer };

}  // namespace candelabra
