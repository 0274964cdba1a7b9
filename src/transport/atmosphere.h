// SPDX-License-Identifier: GPL-3.0-or-later
// Fog and rainbows along a part of a path, and the sky behind everything.
#pragma once

#include "medium/veil.h"
#include "transport/path.h"

namespace candelabra {

/// What fog and rainbows make of the radiance that comes along the path's ray from so far, which
/// may be infinite. Nothing where the path is not in the atmosphere.
Veil veil_along(const World&, const PathState&, double distance);

}  // namespace candelabra
