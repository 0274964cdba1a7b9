// SPDX-License-Identifier: GPL-3.0-or-later
// --preview: shows the picture in a browser while it converges, and renders it again when the scene
// or a file that it reads changes. Called by the commands.
#pragma once

#include "console/console.h"
#include "options/options.h"

namespace candelabra {

/// Serves until a signal ends it. Returns the exit status. Of an animation one frame is shown,
/// initially the first; the page selects it.
int run_preview(const Options&, const std::optional<Animation>&, const Console&, Diagnostics&);

}  // namespace candelabra
