// SPDX-License-Identifier: GPL-3.0-or-later
// A scene for surveys.
#pragma once

#include "lighting/probe.h"

#include <cmath>
#include <optional>

namespace candelabra {

/// First hit of a ray with a glowing ball of radius 1 around the origin, or with a floor at y =
/// -1.5.
inline const auto ball_over_floor = [](const Ray& ray,
                                       double tolerance) -> std::optional<ProbeHit> {
    const double b = dot(ray.origin, ray.direction), c = dot(ray.origin, ray.origin) - 1;
    if (b * b > c) {
        const double t = -b - std::sqrt(b * b - c);
        if (t > tolerance) return ProbeHit{t, ray.at(t), 1e-9, 0, 2.5};
    }
    const double t = (-1.5 - ray.origin.y) / ray.direction.y;
    if (t > tolerance) return ProbeHit{t, Vec3(0, 1, 0), 1e-9, {}, 0};
    return {};
};

}  // namespace candelabra
