// SPDX-License-Identifier: GPL-3.0-or-later
// The objects at which photons are shot, and the effect of surfaces on photons. Filled by
// flatten().
#pragma once

#include "base/ray.h"
#include "base/vector.h"
#include "method/photons.h"
#include "text/span.h"

#include <cstdint>

namespace candelabra {

class Diagnostics;
class World;

/// The effect of a surface on photons.
struct PhotonSurface {
    std::uint32_t target = 0;  ///< in World::photon_targets, counted from 1; 0: none
    PhotonWays ways = {};
    bool collects = true;  ///< whether photons light it
    bool passed = false;   ///< whether photons pass it in a straight line

    friend bool operator==(const PhotonSurface&, const PhotonSurface&) = default;
};

/// Surfaces at which photons are shot together.
struct PhotonTarget {
    Span span;           ///< of the object
    double spacing = 1;  ///< factor on the distance of photons; above 0
    PhotonWays ways = {};
    Vec3 centre = Vec3(0);  ///< of a bounding ball
    double radius = 0;
    bool shot_at = false;  ///< otherwise it only casts a black shadow
};

/// Adds a target if the object is one, and returns the photon settings of its surface.
PhotonSurface photon_surface(World&, const ObjectPhotons&, Span);

/// Finds the places of the targets, and which of them count: those at which photons are shot, and,
/// if there are any, the others as well. Warns of unbounded targets. Too many pairs of lamps and
/// targets are an error.
void place_photon_targets(World&, Diagnostics&);

/// Photon settings of a light source, which decide whether photons replace its direct light through
/// a target. None if it shoots no photons.
PhotonWays ways_of_source(const World&, std::uint32_t light);

/// Photon settings of luminaires.
inline constexpr PhotonWays ways_of_luminaires = {};

/// Whether light of that lamp meets, between both distances along the ray, a target that transmits
/// the lamp's photons.
bool target_between(const World&, const PhotonWays& lamp, const Ray&, double from, double to);

}  // namespace candelabra
