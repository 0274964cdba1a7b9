// SPDX-License-Identifier: GPL-3.0-or-later
// One run over one scene: reads and evaluates it, then checks, dumps or renders it. Called by the
// commands and, for each frame, by animations.
#pragma once

#include "console/console.h"
#include "options/options.h"

namespace candelabra {

/// Runs the scene. Reports errors and returns the exit status.
int run_scene(const Options&, const Console&, Diagnostics&);

}  // namespace candelabra
