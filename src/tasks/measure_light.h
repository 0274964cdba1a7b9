// SPDX-License-Identifier: GPL-3.0-or-later
// The task of --measure: the light at the scene's meters, as a table.
#pragma once

#include "tasks/scene_steps.h"

namespace candelabra {

/// Measures, and writes the table. Returns the exit status.
int measure_light(SceneSteps&);

}  // namespace candelabra
