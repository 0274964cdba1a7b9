// SPDX-License-Identifier: GPL-3.0-or-later
// One run over one scene: reads, evaluates, and checks, dumps or renders it. Called by the commands
// and, for each frame, by animations.
#pragma once

#include "app/console.h"
#include "app/options.h"

namespace candelabra {

/// Says what is wrong; gives the exit status.
int run_scene(const Options&, const Console&, Diagnostics&);

}  // namespace candelabra
