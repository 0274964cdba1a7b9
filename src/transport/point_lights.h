// SPDX-License-Identifier: GPL-3.0-or-later
// Light of one of POV-Ray's sources that a surface reflects, with its shadow. Grids of lights are
// treated as in POV-Ray, too. Called by the direct light for the sources that it samples.
#pragma once

#include "transport/direct_light.h"

namespace candelabra {

/// Radiance towards the viewer by a light source of the world.
Vec3 source_light(const World&, std::uint32_t light, const LitLayer&, const Key&, LightLedger&);

}  // namespace candelabra
