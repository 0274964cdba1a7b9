// SPDX-License-Identifier: GPL-3.0-or-later
// The light that luminaires emit. Their radiance is a function of point, side and direction, and a
// luminaire lights by those points that are seen.
#pragma once

#include "base/rgb.h"
#include "world/world.h"

namespace candelabra {

/// Maximum emission anywhere on the outer or the inner side of a material, per channel.
Rgb greatest_emission(const Material&);

/// A point of a luminaire, and how its light leaves it.
struct EmittingPoint {
    SeenPoint seen;
    Vec3 direction;  ///< unit, away from the luminaire
};

/// The point where a ray meets a luminaire.
inline EmittingPoint emitting_point(const Hit& hit, const Ray& ray) {
    return {{hit.primitive, hit.part, hit.position, hit.normal, hit.side_towards(ray.direction)},
            -ray.direction};
}

/// Radiance of a luminaire at one of its points.
Rgb radiance_of(const World&, const Luminaire&, const EmittingPoint&);

/// Luminance of the brighter side of a primitive at a point; the greatest one if it depends on how
/// the surface faces.
double luminance_at(const World&, PrimitiveIndex, const Vec3& point);

/// Points of a luminaire on one ray are the same if their distances differ by this fraction of
/// them, or by the tolerance of the hit.
inline constexpr double same_point = 1e-9;

/// A point on a ray that starts at a hit of that tolerance.
struct PointOnRay {
    const Ray& ray;  ///< its direction is a unit vector
    double tolerance;
    double distance;
};

/// Radiance of the side of the luminaire that the ray meets at the point, if no surface before is
/// in the way. Of surfaces that lie in the same place, the first one along the ray counts, as for
/// any ray: behind an opaque one the radiance is 0. (World::transmittance() leaves out surfaces so
/// close to the light.)
Rgb radiance_seen(const World&, const Luminaire&, const PointOnRay&);
/// Radiance per unit of length of the media at the point, as a ray sees it that begins in the
/// solids around its origin.
Rgb radiance_seen(const World&, const MediaBox&, const PointOnRay&);

}  // namespace candelabra
