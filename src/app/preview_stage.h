// SPDX-License-Identifier: GPL-3.0-or-later
// Renders a scene for the preview: a coarse picture of all of it at once, finer ones, then as many
// samples as the run asks for. A camera that the page moves takes effect without the scene being
// read again. Called by the preview with each scene that is ready.
#pragma once

#include "app/console.h"
#include "app/preview_desk.h"

namespace candelabra {

/// Both are asked often, by any thread.
struct Leaving {
    std::function<bool()> soon;     ///< the scene is another: one coarse picture is still made
    std::function<bool()> at_once;  ///< the run ends; so it is soon, too
};
void render_on_stage(const Staged&, PreviewDesk&, const Leaving&);

/// Pixels of the whole picture to one of the coarse ones, in each direction. The first is shown
/// only where the second would come late.
inline constexpr int coarse_steps[] = {16, 8, 4, 2};

}  // namespace candelabra
