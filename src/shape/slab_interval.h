// SPDX-License-Identifier: GPL-3.0-or-later
// Where a line is between two parallel planes, as those of the ends of a cylinder.
#pragma once

#include "base/ray.h"

#include <cmath>
#include <limits>

namespace candelabra {

/// The parameters of a line where neither below + t * rise nor above - t * rise is negative: these
/// are its heights over the one plane and under the other. Empty (min > max) where it is nowhere.
inline Interval between_ends(double below, double above, double rise) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (rise == 0 && below >= 0 && above >= 0) return {-infinity, infinity};
    if (rise == 0) return {infinity, -infinity};
    const double base = -below / rise, cap = above / rise;
    return rise > 0 ? Interval{base, cap} : Interval{cap, base};
}

/// The ray's parameter `t` in the plane of an end with this unit normal, to the last digit where
/// the normal is along an axis: things stand on floors, and are met where the floor is. Rays that
/// run along the plane so nearly that they would be met elsewhere keep the parameter they have.
inline double meeting_with_end(const Ray& ray, const Vec3& centre, const Vec3& up, double t) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(up[axis]) != 1 || up[(axis + 1) % 3] != 0 || up[(axis + 2) % 3] != 0) continue;
        const double there = (centre[axis] - ray.origin[axis]) / ray.direction[axis];
        if (std::abs(there - t) <= 1e-9 * std::abs(t)) return there;
    }
    return t;
}

}  // namespace candelabra
