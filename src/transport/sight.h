// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray meets first that a light strategy sends out to try. The cells of a strategy are the
// same whoever asks first, so all ask by this.
#pragma once

#include "lighting/light_guide.h"
#include "world/world.h"

#include <optional>

namespace candelabra {

/// Radiance of a luminaire at a point of it; of volumes along a unit of length.
Vec3 radiance_of(const World&, const Luminaire&, const Vec3& position);

/// Nothing where the ray meets nothing.
std::optional<ProbeHit> first_sight(const World&, const Ray&, double tolerance);

}  // namespace candelabra
