// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a line between two parallel planes, such as the ends of a cylinder.
#pragma once

#include "base/ray.h"

#include <cmath>
#include <limits>

namespace candelabra {

/// The interval of line parameters where neither below + t * rise nor above - t * rise is negative;
/// these are the heights over one plane and under the other. Empty (min > max) if there is none.
inline Interval between_ends(double below, double above, double rise) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (rise == 0 && below >= 0 && above >= 0) return {-infinity, infinity};
    if (rise == 0) return {infinity, -infinity};
    const double base = -below / rise, cap = above / rise;
    return rise > 0 ? Interval{base, cap} : Interval{cap, base};
}

/// The ray's parameter in the plane of an end with this unit normal. It is exact to the last digit
/// where the normal is along an axis: objects stand on floors, and their ends must be hit at the
/// height of the floor. Rays that are almost parallel to the plane, for which the result would
/// differ, keep the parameter `t`.
inline double meeting_with_end(const Ray& ray, const Vec3& centre, const Vec3& up, double t) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(up[axis]) != 1 || up[(axis + 1) % 3] != 0 || up[(axis + 2) % 3] != 0) continue;
        const double there = (centre[axis] - ray.origin[axis]) / ray.direction[axis];
        if (std::abs(there - t) <= 1e-9 * std::abs(t)) return there;
    }
    return t;
}

}  // namespace candelabra
