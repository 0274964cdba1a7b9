// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the program: rendering, checks, dumps, help. All output goes through the console.
#pragma once

#include "console/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// Runs the command that the program's arguments (without its name) ask for. Returns the exit
/// status.
int run(std::span<const std::string_view> arguments, const Console&);

/// Carries out the options. Returns the exit status. `diagnostics`: of reading the options.
int run_with(Options, const Console&, Diagnostics diagnostics);

}  // namespace candelabra
