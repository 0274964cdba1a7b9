// SPDX-License-Identifier: GPL-3.0-or-later
// Tells the crossing at which a ray begins from those that it meets. A ray that leaves a surface
// crosses it at its origin, but rounding moves this crossing along the ray: by the more, the larger
// the shape is and the flatter the ray leaves it. Its distance does not tell it from others then,
// but the tangent plane does. Used where rays meet the surfaces of a world.
#pragma once

#include "base/ray.h"
#include "base/transform.h"

namespace candelabra {

/// Rounding error of a crossing, as a fraction of the coordinates from which it is computed: some
/// thousand times that of a number, for the roots of polynomials and for searches along the ray.
inline constexpr double surface_rounding = 0x1p-40;

/// Whether a ray begins on the surface that it crosses at t, with a normal of any length: whether
/// its origin lies in the tangent plane there, within the rounding error of a shape whose
/// coordinates are up to `size`.
inline bool begins_on(const Ray& ray, double t, const Vec3& normal, double size) {
    const double off = t * dot(ray.direction, normal);
    const double slack = surface_rounding * (size + max_abs_component(ray.origin));
    return off * off <= slack * slack * dot(normal, normal);
}

/// Largest coordinate of a box, in which infinite ones do not count.
inline double largest_coordinate(const Box& box) {
    constexpr double endless = 1e30;
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const double x : {std::abs(box.low[axis]), std::abs(box.high[axis])})
            if (x < endless && x > largest) largest = x;
    return largest;
}

/// Largest coordinate from which the crossings of a ray with a shape are computed, for
/// begins_on(). The box is that of the shape under its transform (null: none). That of an infinite
/// shape tells little, and the origin of the ray in the shape's own space counts instead.
inline double crossing_size(const Box& box, const Transform* transform, const Vec3& origin) {
    const double largest = largest_coordinate(box);
    if (!transform || finite(box)) return largest;
    const Vec3 own = glm::abs(transform->inverse_point(origin));
    const Affine& forward = transform->forward();
    Vec3 sum = glm::abs(forward.translation);
    for (int axis = 0; axis < 3; ++axis)
        sum += own[axis] * glm::abs(forward.rows[static_cast<std::size_t>(axis)]);
    return std::fmax(largest, max_component(sum));
}

}  // namespace candelabra
