// SPDX-License-Identifier: GPL-3.0-or-later
// The first hit of a ray by which a light strategy probes the scene. All callers use this function,
// so that the cells of a strategy do not depend on who probes first.
#pragma once

#include "lighting/probe.h"
#include "world/radiance.h"

#include <optional>

namespace candelabra {

/// Nothing if the ray meets nothing.
std::optional<ProbeHit> first_sight(const World&, const Ray&, double tolerance);

}  // namespace candelabra
