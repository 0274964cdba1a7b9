// SPDX-License-Identifier: GPL-3.0-or-later
// Cosine-weighted directions.
#pragma once

#include "base/circle.h"
#include "base/vector.h"

#include <cmath>
#include <numbers>

namespace candelabra {

/// Returns a unit direction around a unit axis, drawn with the density cosine / pi. u is uniform in
/// [0, 1)^2.
inline Vec3 cosine_direction(const Vec3& axis, const Vec2& u) {
    const auto [x, y] = perpendiculars(axis);
    const double across = std::sqrt(u.x), angle = 2 * std::numbers::pi * u.y;
    return unit(across * on_circle(angle, x, y) + std::sqrt(1 - u.x) * axis);
}

}  // namespace candelabra
