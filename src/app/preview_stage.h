// SPDX-License-Identifier: GPL-3.0-or-later
// Renders a scene for the preview: coarse pictures first, then the samples that the run asks for.
// The page can move the camera without the scene being read again. Called by the preview with each
// scene that is ready.
#pragma once

#include "app/console.h"
#include "app/preview_desk.h"

namespace candelabra {

/// Conditions for leaving the scene. Both are called often, by any thread.
struct Leaving {
    std::function<bool()> soon;     ///< the scene has changed: one coarse picture is still made
    std::function<bool()> at_once;  ///< the run ends; implies soon
};
void render_on_stage(const Staged&, PreviewDesk&, const Leaving&);

/// Pixels of the whole picture to one of the coarse ones, in each direction. The first step is
/// shown only if the second would come late.
inline constexpr int coarse_steps[] = {16, 8, 4, 2};

}  // namespace candelabra
