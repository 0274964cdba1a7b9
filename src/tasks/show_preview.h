// SPDX-License-Identifier: GPL-3.0-or-later
// The task of --preview: the scene goes to the page that renders and shows it.
#pragma once

#include "tasks/scene_steps.h"

namespace candelabra {

/// Compiles the scene for Console::preview, which must be set. Returns the exit status.
int show_preview(SceneSteps&);

}  // namespace candelabra
