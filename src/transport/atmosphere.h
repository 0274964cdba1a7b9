// SPDX-License-Identifier: GPL-3.0-or-later
// Fog and rainbows along a segment of a path, or of light on its way to a point.
#pragma once

#include "medium/veil.h"
#include "transport/path.h"

#include <span>

namespace candelabra {

/// Transmittance and added radiance of fog and rainbows along a ray inside of the solids, up to a
/// distance that may be infinite. No effect where the ray is not in the atmosphere. The key gives
/// the random number of a rainbow's jitter.
Veil veil_along(const World&, const Ray&, double distance, std::span<const PrimitiveIndex> solids,
                const Key&);
/// The same along the path's ray.
Veil veil_along(const World&, const PathState&, double distance);

}  // namespace candelabra
