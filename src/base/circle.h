// SPDX-License-Identifier: GPL-3.0-or-later
// Points of the unit circle and of the unit sphere.
#pragma once

#include "base/elementary.h"
#include "base/vector.h"

#include <cmath>
#include <numbers>

namespace candelabra {

/// Returns cos(angle) x + sin(angle) y: for perpendicular unit vectors, the point of their circle
/// at an angle in radians from x.
inline Vec3 on_circle(double angle, const Vec3& x, const Vec3& y) {
    const auto [sine, cosine] = math::sin_cos(angle);
    return cosine * x + sine * y;
}

/// Returns the cosine and the sine of an angle in radians.
inline Vec2 on_circle(double angle) {
    const auto [sine, cosine] = math::sin_cos(angle);
    return {cosine, sine};
}

/// Returns the unit vector whose y is `height`, turned around y by this fraction of a full turn.
inline Vec3 at_height(double height, double turn) {
    const Vec2 level =
        std::sqrt(std::fmax(0, 1 - height * height)) * on_circle(2 * std::numbers::pi * turn);
    return {level.x, height, level.y};
}

}  // namespace candelabra
