// SPDX-License-Identifier: GPL-3.0-or-later
// Cones with a radius below 0, as in POV-Ray: where one is, the side goes through the axis. Scenes
// may say so; what renders them only knows cones without.
#pragma once

#include "shape/cone.h"

#include <vector>

namespace candelabra {

/// Whether a radius is below 0.
bool is_crossed(const Cone&);
/// One or two cones without that radius, where both are the same.
std::vector<Cone> uncrossed(const Cone&);

}  // namespace candelabra
