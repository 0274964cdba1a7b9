// SPDX-License-Identifier: GPL-3.0-or-later
// One run over one scene: reads and evaluates it, then checks, dumps or renders it. Called by the
// commands and, for each frame, by animations.
#pragma once

#include "console/console.h"
#include "options/options.h"

#include <functional>

namespace candelabra {

class SceneSteps;

/// Runs the scene. Reports errors and returns the exit status.
int run_scene(const Options&, const Console&, Diagnostics&);

/// Does other work over the scene, once its text has been read. Reports errors and returns the exit
/// status.
int run_over_scene(const Options&, const Console&, Diagnostics&,
                   const std::function<int(SceneSteps&)>& work);

}  // namespace candelabra
