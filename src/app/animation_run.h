// SPDX-License-Identifier: GPL-3.0-or-later
// Renders the frames of an animation in order and joins them to a movie. Each frame is prepared
// while the previous one is rendered. Called by the commands.
#pragma once

#include "console/console.h"
#include "options/animation.h"
#include "options/options.h"

namespace candelabra {

/// Sets the facts that the scene can query in a frame.
void set_frame(RunFacts&, const AnimationSettings&, const Animation&, const AnimationFrame&);

/// Renders the animation. Reports errors and returns the exit status.
int run_animation(const Options&, const Animation&, const Console&, Diagnostics&);

}  // namespace candelabra
