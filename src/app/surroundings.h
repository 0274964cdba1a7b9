// SPDX-License-Identifier: GPL-3.0-or-later
// What surrounds each run over a scene, whatever its task is: the INI file of its options, logs of
// its messages, limits, the sandbox, and warnings of what is left out.
#pragma once

#include "console/console.h"
#include "options/options.h"

#include <functional>

namespace candelabra {

/// Does the work with the options as they are settled, and a console that keeps logs. The options
/// name a scene and have no errors. Returns the exit status.
int run_with_surroundings(Options, const Console&, Diagnostics&,
                          const std::function<int(const Options&, const Console&)>& work);

}  // namespace candelabra
