// SPDX-License-Identifier: GPL-3.0-or-later
// The tasks of --check: errors and warnings of a scene, without a picture.
#pragma once

#include "tasks/scene_steps.h"

namespace candelabra {

/// Evaluates the scene, and compiles it where statistics are wanted. Returns the exit status.
int check_scene(SceneSteps&);

/// Only parses the scene's own text. Returns the exit status.
int check_syntax(SceneSteps&);

}  // namespace candelabra
