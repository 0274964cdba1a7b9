// SPDX-License-Identifier: GPL-3.0-or-later
// Renders the frames of an animation one after the other, and joins them to a film. Called by the
// commands.
#pragma once

#include "app/animation.h"
#include "app/console.h"
#include "app/options.h"

/// Says what is wrong; gives the exit status.
int run_animation(const Options&, const Animation&, const Console&, Diagnostics&);
