// SPDX-License-Identifier: GPL-3.0-or-later
// The tasks of --dump: one stage on the way from a text to a picture, as text.
#pragma once

#include "tasks/scene_steps.h"

namespace candelabra {

/// Prints the stage that the task of the options names. Returns the exit status.
int dump_stage(SceneSteps&);

}  // namespace candelabra
