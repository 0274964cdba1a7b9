// SPDX-License-Identifier: GPL-3.0-or-later
// The first hit of a ray by which a light strategy probes the scene. All callers use this function,
// so that the cells of a strategy do not depend on who probes first.
#pragma once

#include "lighting/light_guide.h"
#include "world/world.h"

#include <optional>

namespace candelabra {

/// Radiance of a luminaire at one of its points; for volumes, per unit of length.
Vec3 radiance_of(const World&, const Luminaire&, const Vec3& position);

/// Nothing if the ray meets nothing.
std::optional<ProbeHit> first_sight(const World&, const Ray&, double tolerance);

}  // namespace candelabra
