// SPDX-License-Identifier: GPL-3.0-or-later
// The result of intersecting a ray with a world.
#pragma once

#include "base/short_list.h"
#include "world/geometry.h"

namespace candelabra {

/// The side of a surface that is seen. As in POV-Ray, the inner one may have its own texture.
enum class Side : bool { outer, inner };

/// A point where a ray met a surface.
struct Hit {
    PrimitiveIndex primitive = no_primitive;
    std::uint32_t part = 0;  ///< of shapes and leaves: see Crossing
    Vec3 position = Vec3(0);
    Vec3 normal = Vec3(0);         ///< unit geometric normal, outward
    Vec3 smooth_normal = Vec3(0);  ///< unit shading normal, outward
    /// Rays that start here ignore hits nearer than this, to miss the surface they start from.
    double tolerance = 0;

    /// The side that a ray of this direction meets.
    Side side_towards(const Vec3& direction) const {
        return dot(normal, direction) > 0 ? Side::inner : Side::outer;
    }
};

/// A point of a surface, and the side from which it is seen.
struct SeenPoint {
    PrimitiveIndex primitive;
    std::uint32_t part;  ///< as in Hit
    Vec3 point;
    Vec3 normal;  ///< unit, of the geometry
    Side side;
};

/// The purpose of a ray: some objects are invisible to some kinds of rays.
enum class RayKind { camera, reflected, light, gathering };

/// The solids that contain a ray, one primitive of each, in the order of entering.
using EnteredSolids = ShortList<PrimitiveIndex, 6>;

/// The change of these solids where a ray passes a surface.
enum class Passing { enters, leaves_innermost, leaves_outer };

}  // namespace candelabra
