// SPDX-License-Identifier: GPL-3.0-or-later
// Shutter samples: while the camera's shutter stays open, the scene at some later times is a
// separate world. The light report has one row for a light in all of these worlds. Called by
// compile().
#pragma once

#include "text/source.h"
#include "world/world.h"

namespace candelabra {

/// Gives a world and its shutter samples one common list of the statements that make lights, by
/// file and position, in the order of the samples. An included file is read anew for each sample,
/// so sources are compared by name.
void share_light_statements(World&, const SourceStore&);

}  // namespace candelabra
