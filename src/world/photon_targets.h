// SPDX-License-Identifier: GPL-3.0-or-later
// The objects of a world that photons are shot at, and what photons do at its surfaces. Filled by
// flatten().
#pragma once

#include "base/vector.h"
#include "method/photons.h"
#include "text/span.h"

#include <cstdint>

namespace candelabra {

class Diagnostics;
class World;

/// What photons do at a surface.
struct PhotonSurface {
    std::uint32_t target = 0;  ///< in World::photon_targets, counted from 1; 0: of none
    PhotonWays ways = {};
    bool collects = true;  ///< it shows what photons bring
    bool passed = false;   ///< photons pass it in a straight line

    friend bool operator==(const PhotonSurface&, const PhotonSurface&) = default;
};

/// Surfaces that photons are shot at together.
struct PhotonTarget {
    Span span;           ///< of the object
    double spacing = 1;  ///< factor of the distance of photons; above 0
    PhotonWays ways = {};
    Vec3 centre = Vec3(0);  ///< of a ball around it
    double radius = 0;
    bool shot_at = false;  ///< otherwise it only throws its black shadow
};

/// Numbers a new target, if the object is one.
PhotonSurface photon_surface(World&, const ObjectPhotons&, Span);

/// Finds where the targets are, and which of them count: those that photons are shot at, and
/// others if there is one of these. Warns of targets without end; more pairs of lamps and targets
/// than there may be are an error.
void place_photon_targets(World&, Diagnostics&);

/// Whether light that comes straight from the source through a target counts, or photons instead:
/// what the source says of photons. Nothing where it shoots none.
PhotonWays ways_of_source(const World&, std::uint32_t light);

/// What luminaires say of photons.
inline constexpr PhotonWays ways_of_luminaires = {};

/// Whether light of that lamp meets, between both distances along the ray, a target that its
/// photons go through.
bool target_between(const World&, const PhotonWays& lamp, const Ray&, double from, double to);

}  // namespace candelabra
