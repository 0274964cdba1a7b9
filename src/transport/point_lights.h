// SPDX-License-Identifier: GPL-3.0-or-later
// What a surface sends on of the light of one of POV-Ray's sources, with its shadow: as POV-Ray
// does, for a grid of lights as well. Called by the direct light for the sources that it asks.
#pragma once

#include "transport/direct_light.h"

namespace candelabra {

/// Radiance towards the viewer by a light of the world.
Vec3 source_light(const World&, std::uint32_t light, const LitLayer&, const Key&, LightLedger&);

}  // namespace candelabra
