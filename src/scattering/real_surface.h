// SPDX-License-Identifier: GPL-3.0-or-later
// How a shading normal and the real surface are brought together: which side of both a direction is
// on, a normal that faces the viewer, and reflections that leave the surface.
#pragma once

#include "scattering/shading.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

/// `none`: the direction is on different sides of the real surface and of the shading normal's
/// horizon, and no light comes from there.
enum class LitSide { front, behind, none };

/// The side of a unit direction, as seen from the viewer.
inline LitSide side_of(const Shading& s, const Vec3& direction) {
    const double shown = dot(s.normal, direction), real = dot(s.geometric_normal, direction);
    // Below 1e-10 POV-Ray takes light for light from behind.
    if (shown >= 1e-10 && real > 0) return LitSide::front;
    return shown < 0 && real < 0 ? LitSide::behind : LitSide::none;
}

/// Whether light from behind is scattered towards the viewer.
inline bool answers_behind(const Shading& s) {
    return !s.finish->microfacet.on && (s.both_sides || s.finish->diffuse_back != 0);
}

/// The shading normal, bent towards the viewer where it faces away, or where it is closer to a
/// right angle than the real surface is. A normal that points below the real surface is turned
/// over first: it was turned to the viewer there.
inline Vec3 fitted_normal(const Shading& s) {
    constexpr double least_cosine = 0.05;
    const Vec3 outer = dot(s.normal, s.geometric_normal) < 0 ? -s.normal : s.normal;
    const double least = std::min(least_cosine, -dot(s.geometric_normal, s.view));
    const double seen = -dot(outer, s.view);
    if (seen >= least) return outer;
    const Vec3 across = unit(outer + seen * s.view);
    if (across == Vec3(0)) return s.geometric_normal;
    return unit(std::sqrt(1 - least * least) * across - least * s.view);
}

/// A direction that leaves the real surface: one that leads into it is mirrored by it.
inline Vec3 lifted(const Vec3& direction, const Vec3& geometric_normal) {
    return dot(direction, geometric_normal) < 0 ? mirrored(direction, geometric_normal) : direction;
}

}  // namespace candelabra
