// SPDX-License-Identifier: GPL-3.0-or-later
// The index of a world as a picture, for --dump index: what a plane through the middle of nearly
// all cells cuts of them. Depends on the world only.
#pragma once

#include "world/world.h"

#include <string>

namespace candelabra {

/// A drawing in SVG. The plane is square to the axis that the camera looks along most nearly, and
/// the drawing as upright as the camera. Cells are the darker, the more items they have; those that
/// make up a node have a line around them, the finer, the deeper it lies.
std::string index_slice(const World&);

}  // namespace candelabra
