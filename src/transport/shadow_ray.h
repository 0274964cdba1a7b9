// SPDX-License-Identifier: GPL-3.0-or-later
// A straight line from a layer towards light, and the fraction of the light that is left at the
// layer: all kinds of direct light ask here.
#pragma once

#include "base/rgb.h"
#include "transport/arrival.h"
#include "transport/light_left.h"

namespace candelabra {

/// The rules by which light of a source comes to a layer, where they are not those of a ray that
/// the layer follows.
struct SourceRules {
    AirOnWay air;
    PhotonWays photons;  ///< the source's photon settings
};

class ShadowRay {
public:
    /// Light that comes by the rules of a ray which the layer follows: that of luminaires and of
    /// the sky. `key`: the random numbers of media on the way.
    ShadowRay(const ArrivingLight&, const Vec3& direction, const Key& key);
    /// Light of a source.
    ShadowRay(const ArrivingLight&, const Vec3& direction, const Key& key, const SourceRules&);

    const Ray& ray() const { return ray_; }

    /// Fraction of the light from a point at that distance that surfaces and media let through. It
    /// is 0 where photons bring the light instead.
    Rgb left(double distance) const;
    /// The same for light from behind everything, of which photons bring none.
    Rgb left_from_sky() const;
    /// Fraction of the light from a point of a surface that media let through: 0 if a surface lies
    /// between, even a clear one. `tolerance` is that of the point.
    Rgb left_by_air(double distance, double tolerance) const;

    /// Radiance of a luminaire at a point on the ray, as the layer sees it. It is 0 where something
    /// else covers it in its place.
    Rgb emitted(const Luminaire&, double distance) const;
    /// The same of a surface that the ray has met.
    Rgb emitted(const Luminaire&, const Hit&, double distance) const;
    /// Radiance of media per unit of length.
    Rgb emitted(const MediaBox&, double distance) const;

private:
    WayOfLight way(double distance, bool ends) const;
    template <class Glowing>
    Rgb left_by_lamp(const Glowing&, double distance) const;

    const ArrivingLight& at_;
    Ray ray_;
    Key key_;
    AirOnWay air_;
    double apart_ = 0;  ///< see World::Shade
    PhotonWays photons_ = ways_of_luminaires;
    EnteredSolids around_;  ///< solids that contain the ray where it leaves the vertex
};

}  // namespace candelabra
