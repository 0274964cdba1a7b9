// SPDX-License-Identifier: GPL-3.0-or-later
// How the light of POV-Ray's light sources changes with distance and direction, besides the inverse
// square law that all estimates of luminaires include: it may fade, and it may fill only a cone.
// Describes one source, or a cluster of sources in a ball. Used by the light samplers to weight
// sources; never 0 at a point that one of the sources lights.
#pragma once

#include "base/vector.h"

#include <cmath>
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

/// The numbers of a falloff from which estimates are made, in one precision.
template <class T>
struct FalloffTerms {
    T fade_power = 0, per_fade_distance = 1;
    glm::vec<3, T> axis = glm::vec<3, T>(0);
    T dark = -10;    ///< cosine of the cone's half angle; much below -1: no cone
    T per_edge = 1;  ///< one over the difference of that to the cosine of the bright part
};

/// `scale`: the unit of length of the estimates is the scene's over this.
FalloffTerms<double> terms_of(const Falloff&, double scale = 1);

/// Factor by which the falloff deviates from the inverse square law at the distance from a point to
/// the middle of the ball, to which `v` leads. Within the ball the distance counts as its radius,
/// and the cone does not matter. `power` is called for a distance and the power of the fading.
/// Arithmetic without branches, so that loops over it are vectorised.
template <class T, class Power>
[[gnu::always_inline]] inline T against_square_law(const FalloffTerms<T>& f,
                                                   const glm::vec<3, T>& v, T radius,
                                                   const Power& power) {
    constexpr T slack = static_cast<T>(cone_slack), edge = static_cast<T>(cone_edge);
    const T r2 = radius * radius, d2 = v.x * v.x + v.y * v.y + v.z * v.z;
    const T outside2 = d2 > r2 ? d2 : r2;
    const T distance = std::sqrt(outside2);
    const T far = power(distance * f.per_fade_distance, f.fade_power);
    const T inverse = 1 / distance, sine = radius * inverse;
    const T cosine2 = 1 - sine * sine, cosine = std::sqrt(cosine2 > 0 ? cosine2 : 0);
    const T along = -(f.axis.x * v.x + f.axis.y * v.y + f.axis.z * v.z) * inverse;
    const T across2 = 1 - along * along, across = std::sqrt(across2 > 0 ? across2 : 0);
    // The cosine of the angle to the axis less that of the ball's radius, as seen from the point.
    const T turned = along * cosine + across * sine;
    const T nearest = along < cosine ? turned : 1;
    const T inside = nearest + slack - f.dark;
    const T t0 = inside * f.per_edge, t = t0 < 1 ? t0 : 1;
    const T smooth = t * t * (3 - 2 * t), lit = smooth > edge ? smooth : edge;
    const T share = inside > 0 ? lit : 0;
    const T kept = d2 > r2 ? share : 1;
    return outside2 * kept * (2 / (1 + far));
}

/// The same in double precision.
double against_square_law(const Falloff&, const Vec3& v, double radius);

/// Falloff of both in one ball, as far-reaching as either; not 0 where either is not 0.
Falloff join(const Falloff&, const Falloff&);

}  // namespace candelabra
