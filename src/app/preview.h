// SPDX-License-Identifier: GPL-3.0-or-later
// --preview: shows the picture in a browser while it becomes better, and makes it anew when the
// scene or a file that it reads changes. Called by the commands.
#pragma once

#include "app/console.h"
#include "app/options.h"

namespace candelabra {

/// Serves until a signal ends it; gives the exit status. Of an animation one frame is shown, the
/// first at first; the page chooses.
int run_preview(const Options&, const std::optional<Animation>&, const Console&, Diagnostics&);

}  // namespace candelabra
