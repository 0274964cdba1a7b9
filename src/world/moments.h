// SPDX-License-Identifier: GPL-3.0-or-later
// The moments of an open shutter are scenes of their own; what is told of their lights is told of
// all of them together.
#pragma once

#include "text/source.h"
#include "world/world.h"

/// Gives a world and its other moments one list of the statements that make lights: by file and
/// place, in the order in which the moments have them. An included file is read anew for each
/// moment, so sources are told apart by their names.
void share_light_statements(World&, const SourceStore&);
