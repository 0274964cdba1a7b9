// SPDX-License-Identifier: GPL-3.0-or-later
// Solids whose media light the scene become luminaires: a solid is cut into boxes, each of which is
// one, so that the light strategies know its near parts from its far ones. Called when a world's
// primitives and materials are complete, and by those who ask for the light.
#pragma once

#include "text/diagnostic.h"
#include "world/emitters.h"

#include <span>

namespace candelabra {

/// Whether what fills the inside of such primitives lights the scene.
bool lights_from_inside(const Material&);

/// Fills WorldLights::volumes, and adds to its luminaires. What has no end is warned of. Where they
/// are not `surveyed`, each solid is one box that glows evenly, as if only their number mattered.
void add_volumes(World&, std::span<const GlowingPrimitive>, bool surveyed, Diagnostics&);

/// Radiance that the media of that volume emit at a point, along a unit of length. Where parts that
/// share their media are inside of each other, all of them together emit it. As in POV-Ray there is
/// nothing where an even number of them are, nor in a solid that is not hollow.
Vec3 volume_emission(const World&, PrimitiveIndex volume, const Vec3& point);

/// The innermost one of those solids whose media light the scene; null: none.
const GlowingVolume* volume_among(const World&, std::span<const PrimitiveIndex> solids);

}  // namespace candelabra
