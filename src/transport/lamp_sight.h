// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires as an observer sees them, one by one: for ratings of glare, to which each of them adds
// by its own luminance and place.
#pragma once

#include "world/world.h"

#include <optional>

namespace candelabra {

/// Returns a direction in which the luminaire is visible from a point, with its density per
/// steradian, so that the sum of 1 / density over many is the solid angle that is visible; u is in
/// [0, 1)^2. What is in front of it is looked through as far as it is clear. Returns nothing if the
/// drawn direction does not show it, and for media that glow.
std::optional<LightDirection> sight_of_lamp(const World&, LightIndex, const Vec3& from,
                                            const Vec2& u);

}  // namespace candelabra
