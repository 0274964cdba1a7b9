// SPDX-License-Identifier: GPL-3.0-or-later
// Fog and rainbows along a segment of a path.
#pragma once

#include "medium/veil.h"
#include "transport/path.h"

namespace candelabra {

/// Transmittance and added radiance of fog and rainbows along the path's ray, up to a distance that
/// may be infinite. No effect where the path is not in the atmosphere.
Veil veil_along(const World&, const PathState&, double distance);

}  // namespace candelabra
