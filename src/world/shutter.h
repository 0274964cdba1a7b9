// SPDX-License-Identifier: GPL-3.0-or-later
// Shutter samples: while the camera's shutter stays open, the scene at some later times is a world
// of its own. The light report has one row for a light in all of these worlds. Called by compile().
#pragma once

#include "text/source.h"
#include "world/world.h"

namespace candelabra {

/// Gives a world and its shutter samples one list of the statements that make lights: by file and
/// place, in the order in which the samples have them. An included file is read anew for each
/// sample, so sources are told apart by their names.
void share_light_statements(World&, const SourceStore&);

}  // namespace candelabra
