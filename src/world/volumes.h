// SPDX-License-Identifier: GPL-3.0-or-later
// Makes lights of solids whose media light the scene: a solid is cut into boxes, so that light
// strategies can tell its near parts from its far ones. Called when a world's primitives and
// materials are complete and its luminaires are known, and for the emission of the media.
#pragma once

#include "base/rgb.h"
#include "text/diagnostic.h"
#include "world/emitters.h"

#include <span>

namespace candelabra {

/// Whether two primitives belong to one solid, or share their interior.
bool is_same_solid(const World&, PrimitiveIndex, PrimitiveIndex);

/// Whether media inside of such primitives light the scene.
bool lights_from_inside(const Material&);

/// Whether such media glow within their solid only: those that are luminaires, and, where energy is
/// kept, all. As in POV-Ray, a ray that leaves a solid through an opening still meets the others.
bool glows_within(const World&, const Material&);

/// Whether a surface that parts inside from outside does not do so everywhere.
bool has_openings(const World&);

/// Fills WorldLights::glow_beside_openings.
void find_openings(World&);

/// Fills WorldLights::volumes and WorldLights::media, and warns of unbounded volumes, whose media
/// are no luminaires then: paths find their light by chance. If not `surveyed`, each solid is one
/// evenly glowing box, for callers that only count them.
void add_volumes(World&, std::span<const GlowingPrimitive>, bool surveyed, Diagnostics&);

/// Radiance per unit of length that the media of a volume emit at a point. Where parts that share
/// their media overlap, they emit it together. As in POV-Ray, nothing is emitted where an even
/// number of them overlap, nor in a solid that is not hollow.
Rgb volume_emission(const World&, PrimitiveIndex volume, const Vec3& point);

/// A ray inside of some solids, for emission that it sees at a distance.
struct SightOfVolume {
    const Ray& ray;
    double tolerance;
    double distance;
    std::span<const PrimitiveIndex> solids;
};
/// The same as a ray that is followed sees it: the media of the solids that the ray has entered
/// through a surface and not left, on its way from one surface to the next.
Rgb volume_emission(const World&, PrimitiveIndex volume, const SightOfVolume&);

/// Whether the point is inside of the solid.
bool is_within(const World&, PrimitiveIndex solid, const Vec3& point);

/// Returns the innermost of those solids whose media light the scene; null if there is none.
const GlowingVolume* volume_among(const World&, std::span<const PrimitiveIndex> solids);

}  // namespace candelabra
