// SPDX-License-Identifier: GPL-3.0-or-later
// The task of --export-mesh: the scene's objects as a mesh in a file.
#pragma once

#include "tasks/scene_steps.h"

namespace candelabra {

/// Makes the mesh, and writes it. Returns the exit status.
int export_mesh(SceneSteps&);

}  // namespace candelabra
