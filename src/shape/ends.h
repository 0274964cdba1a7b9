// SPDX-License-Identifier: GPL-3.0-or-later
// Where a line is between two parallel planes, as those of the ends of a cylinder.
#pragma once

#include "base/ray.h"

#include <limits>

/// The parameters of a line where neither below + t * rise nor above - t * rise is negative: these
/// are its heights over the one plane and under the other. Empty (min > max) where it is nowhere.
inline Interval between_ends(double below, double above, double rise) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (rise == 0 && below >= 0 && above >= 0) return {-infinity, infinity};
    if (rise == 0) return {infinity, -infinity};
    const double base = -below / rise, cap = above / rise;
    return rise > 0 ? Interval{base, cap} : Interval{cap, base};
}

/// The ray's parameter in the plane of an end with this unit normal, to the last digit where the
/// normal is along an axis: things stand on floors, and are met where the floor is.
inline double meeting_with_end(const Ray& ray, const Vec3& centre, const Vec3& up) {
    return dot(centre - ray.origin, up) / dot(ray.direction, up);
}
