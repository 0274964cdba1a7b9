// SPDX-License-Identifier: GPL-3.0-or-later
// The program in place of POV-Ray's: for programs that write scenes and call `povray` on them.
#pragma once

#include "console/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// The command that a name of the program stands for: `povray` for candelabra-povray and for a link
/// that is called povray, otherwise an empty text. `path`: the name as called.
std::string_view command_named(std::string_view path);

/// Renders a scene as POV-Ray's program does with the same arguments: with its usual size, without
/// antialiasing unless it is asked for, with its include files if they are installed, and with no
/// light from things that glow. Switches of its program for Windows, such as /EXIT, are accepted.
/// Returns the exit status.
int run_povray(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
