// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing of the world's index for --dump index: its cross-section with a plane through the
// middle of nearly all cells. Depends on the world only.
#pragma once

#include "world/world.h"

#include <string>

namespace candelabra {

/// Returns a drawing in SVG. The plane is perpendicular to the axis closest to the camera's
/// direction, and the drawing is oriented like the camera's picture. Cells with more items are
/// darker. The cells of a node share an outline, which is thinner for deeper nodes.
std::string index_slice(const World&);

}  // namespace candelabra
