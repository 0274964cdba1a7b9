// SPDX-License-Identifier: GPL-3.0-or-later
// Where light paths from light sources and the sky should arrive: about what the camera sees. Some
// of them arrive elsewhere, so that no light is lost.
#pragma once

#include "base/vector.h"
#include "world/shot.h"

#include <vector>

namespace candelabra {

/// A place of a surface that the camera sees, or that lights such a place.
struct SeenPlace {
    Vec3 position;
    Vec3 normal;  ///< unit, on the side that is seen
    double tolerance;
};
/// Whether a surface is visible from the place on the side of its normal.
bool sees(const World&, const SeenPlace&, const Vec3& position, const Vec3& normal,
          double tolerance);
/// Some places, spread over the picture.
std::vector<SeenPlace> seen_places(const Shot&);

/// A ball around most of them.
struct LitRegion {
    Vec3 centre = Vec3(0);
    double radius = 1;
    double upstream = 1;  ///< a distance from the centre beyond all finite things

    /// Greatest cosine to a unit normal at which a place of the region is visible; 0 if all of the
    /// region is behind the surface, and 1 from within.
    double greatest_cosine(const Vec3& from, const Vec3& normal) const;

    static LitRegion of(const Shot&, const std::vector<SeenPlace>&);
};

/// Returns a point of a disc around 0, uniformly; u is in [0, 1)^2.
Vec3 point_in_disc(const Vec3& axis, double radius, const Vec2& u);

inline constexpr double beside_disc = 0.1;
/// Returns a point of the plane through 0 that is perpendicular to the axis: mostly a point of the
/// disc with that radius, and elsewhere the rarer the farther away. `beside`: the fraction of the
/// points that lie outside of the disc.
Vec3 point_about_disc(const Vec3& axis, double radius, const Vec2& u, double beside = beside_disc);
/// 1 over the density of such points, per unit of area, at a distance from 0.
double area_about_disc(double away, double radius, double beside = beside_disc);

}  // namespace candelabra
