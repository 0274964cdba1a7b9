// SPDX-License-Identifier: GPL-3.0-or-later
// A picture between its commands, with the facts that they are told.
#pragma once

#include "app/options.h"

#include <functional>

namespace candelabra {

CommandFacts command_facts(const Options&);

/// The work's exit status, and whether more pictures follow.
Outcome with_frame_commands(const Options&, const std::function<int()>& work);

}  // namespace candelabra
