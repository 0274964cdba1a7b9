// SPDX-License-Identifier: GPL-3.0-or-later
// Cones with a radius below 0, as in POV-Ray: their side passes through the axis. Scenes may
// contain them; the renderer supports only non-negative radii.
#pragma once

#include "shape/cone.h"

#include <vector>

namespace candelabra {

/// Whether a radius is below 0.
bool is_crossed(const Cone&);
/// Returns one or two cones with radii of at least 0 that together form the same surface.
std::vector<Cone> uncrossed(const Cone&);

}  // namespace candelabra
