// SPDX-License-Identifier: GPL-3.0-or-later
// Renders the frames of an animation one after the other, each prepared while the one before is
// rendered, and joins them to a film. Called by the commands.
#pragma once

#include "app/animation.h"
#include "app/console.h"
#include "app/options.h"

namespace candelabra {

/// What the scene is told in that frame.
void set_frame(RunFacts&, const AnimationSettings&, const Animation&, const AnimationFrame&);

/// Says what is wrong; gives the exit status.
int run_animation(const Options&, const Animation&, const Console&, Diagnostics&);

}  // namespace candelabra
