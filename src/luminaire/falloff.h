// SPDX-License-Identifier: GPL-3.0-or-later
// How the light of POV-Ray's light sources changes with distance and direction, besides the inverse
// square law that all estimates of luminaires include: it may fade, and it may fill only a cone.
// Describes one source, or a cluster of sources in a ball. Used by the light samplers to weight
// sources; never 0 at a point that one of the sources lights.
#pragma once

#include "base/vector.h"

#include <numbers>

namespace candelabra {

struct Falloff {
    double fade_distance = 0;  ///< 0: no fading
    double fade_power = 0;     ///< 0: no fading
    Vec3 axis = Vec3(0);       ///< unit axis of the cone
    /// Half angles of the cone: no light beyond `dark` (pi: light in all directions), and full
    /// light within `bright`.
    double dark = std::numbers::pi, bright = std::numbers::pi;

    bool fades() const { return fade_distance > 0 && fade_power > 0; }
    bool all_around() const { return dark >= std::numbers::pi; }
};

/// Allowance for rounding in the cosine of the angle to a cone's axis, and minimum fraction of the
/// light that points at the edge of a cone are estimated to receive.
inline constexpr double cone_slack = 1e-5, cone_edge = 1e-3;

/// Factor by which the falloff deviates from the inverse square law at the distance from a point to
/// the middle of the ball, to which `v` leads. Within the ball the distance counts as its radius,
/// and the cone does not matter.
double against_square_law(const Falloff&, const Vec3& v, double radius);

/// Falloff of both in one ball, as far-reaching as either; not 0 where either is not 0.
Falloff join(const Falloff&, const Falloff&);

}  // namespace candelabra
