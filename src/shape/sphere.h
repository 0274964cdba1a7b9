// SPDX-License-Identifier: GPL-3.0-or-later
// A sphere: the shape of most luminaires, so the tracer also stores it in a dedicated form.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// All points at one distance from a centre.
struct Sphere {
    Vec3 centre = Vec3(0);
    double radius = 1;

    static const ItemInfo vocabulary;
};

Box bounds(const Sphere&);
void crossings(const Sphere&, const Ray&, Crossings&);
bool inside(const Sphere&, const Vec3&);
/// See shape.h.
std::string vanishes(const Sphere&);
/// Bounds of the part of the surface in the cell; empty when it does not pass through it.
Box clipped_bounds(const Sphere&, const Box& cell);

/// The first crossing in the range, or range.max when there is none. Stable for far and for tiny
/// spheres: the discriminant comes from the distance of the closest approach (Haines et al., Ray
/// Tracing Gems, chapter 7).
inline double first_crossing(const Vec3& centre, double radius, const Ray& ray,
                             const Interval& range) {
    const Vec3 f = ray.origin - centre;
    const double a = dot(ray.direction, ray.direction);
    const double b = -dot(f, ray.direction);
    const Vec3 closest = f + (b / a) * ray.direction;
    const double discriminant = radius * radius - dot(closest, closest);
    if (discriminant < 0) return range.max;
    const double c = dot(f, f) - radius * radius;
    const double q = b + std::copysign(std::sqrt(a * discriminant), b);
    const double t0 = c / q, t1 = q / a;
    const double near = t0 < t1 ? t0 : t1, far = t0 < t1 ? t1 : t0;
    if (near > range.min) return near < range.max ? near : range.max;
    return far > range.min && far < range.max ? far : range.max;
}

}  // namespace candelabra
