// SPDX-License-Identifier: GPL-3.0-or-later
// Angles as shares of a whole turn, by which planes are wrapped around spheres, cylinders and
// rings. Used by warps, by pictures and to lay u and v on shapes.
#pragma once

#include "base/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

/// The angle around the y axis, from the x axis towards z: 0 to 1 for a whole turn.
inline double turn(double x, double z) {
    using std::numbers::pi;
    if (z == 0) return x > 0 ? 0 : 0.5;
    const double angle = std::acos(x / std::sqrt(x * x + z * z));
    return (z < 0 ? 2 * pi - angle : angle) / (2 * pi);
}

/// The angle around a tube, from its inner side on, downwards first: 0 to 1 for a whole turn.
/// `outwards` is the distance from the tube's middle away from the ring's axis, `up` that along it.
inline double turn_of_tube(double outwards, double up) {
    using std::numbers::pi;
    const double distance = std::sqrt(outwards * outwards + up * up);
    const double angle = std::acos(std::clamp(-outwards / distance, -1.0, 1.0));
    return (up > 0 ? 2 * pi - angle : angle) / (2 * pi);
}

}  // namespace candelabra
