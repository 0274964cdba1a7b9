// SPDX-License-Identifier: GPL-3.0-or-later
// Angles in turns, by which planes are wrapped around spheres, cylinders and tori. Used by warps,
// by pictures and for the uv coordinates of shapes.
#pragma once

#include "base/elementary.h"
#include "base/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

/// Angle around the y axis, from the x axis towards z, in turns from 0 to 1.
inline double turn(double x, double z) {
    using std::numbers::pi;
    if (z == 0) return x > 0 ? 0 : 0.5;
    const double angle = math::acos(x / std::sqrt(x * x + z * z));
    return (z < 0 ? 2 * pi - angle : angle) / (2 * pi);
}

/// Angle around a torus's tube, from its inner side and at first downwards, in turns from 0 to 1.
/// `outwards` is the distance from the tube's centre away from the ring's axis, `up` the one along
/// it. 0 at the tube's centre.
inline double turn_of_tube(double outwards, double up) {
    using std::numbers::pi;
    const double distance = std::sqrt(outwards * outwards + up * up);
    if (distance == 0) return 0;
    const double angle = math::acos(std::clamp(-outwards / distance, -1.0, 1.0));
    return (up > 0 ? 2 * pi - angle : angle) / (2 * pi);
}

}  // namespace candelabra
