// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the shell commands before and after a picture.
#pragma once

#include "app/shell_commands.h"
#include "options/options.h"

#include <functional>

namespace candelabra {

CommandFacts command_facts(const Options&);

/// Returns the exit status of the work, and whether more pictures follow.
Outcome with_frame_commands(const Options&, const std::function<int()>& work);

}  // namespace candelabra
