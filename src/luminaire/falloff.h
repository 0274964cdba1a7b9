// SPDX-License-Identifier: GPL-3.0-or-later
// How the light of POV-Ray's sources changes on its way, besides the square law that all estimates
// of luminaires have: it fades as the source says, and may fill a cone only. Of one source, or of
// a cluster of them in a ball. Used by the light samplers to weigh sources; never 0 at a point that
// one of them lights.
#pragma once

#include "base/vector.h"

#include <numbers>

namespace candelabra {

struct Falloff {
    double fade_distance = 0;  ///< 0: it does not fade
    double fade_power = 0;     ///< 0: it does not fade
    Vec3 axis = Vec3(0);       ///< unit, of the cone
    /// Half angles of the cone: there is no light beyond the first (pi: it shines all around), and
    /// all of it within the second.
    double dark = std::numbers::pi, bright = std::numbers::pi;

    bool fades() const { return fade_distance > 0 && fade_power > 0; }
    bool all_around() const { return dark >= std::numbers::pi; }
};

/// Room for rounding in the cosine of the angle to a cone's axis, and the share of the light that
/// points at the very edge of the cone are thought to get at least.
inline constexpr double cone_slack = 1e-5, cone_edge = 1e-3;

/// What the square law, for the distance that `v` leads to the middle of the ball, must be
/// multiplied by. Within the ball the distance is its radius, and the cone is everywhere.
double against_square_law(const Falloff&, const Vec3& v, double radius);

/// Of both together in one ball: as the one that reaches further; not 0 where one of them is not.
Falloff join(const Falloff&, const Falloff&);

}  // namespace candelabra
