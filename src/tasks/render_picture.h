// SPDX-License-Identifier: GPL-3.0-or-later
// The usual task: the picture, with all files that belong to it.
#pragma once

#include "tasks/scene_steps.h"

namespace candelabra {

/// Renders the picture or a shard of it, and writes it. Returns the exit status.
int render_picture(SceneSteps&);

}  // namespace candelabra
