// SPDX-License-Identifier: GPL-3.0-or-later
// The task of --light-balance: where the light of each lamp ends, as a table.
#pragma once

#include "tasks/scene_steps.h"

namespace candelabra {

/// Follows the light, and writes the table. Returns the exit status.
int balance_light(SceneSteps&);

}  // namespace candelabra
