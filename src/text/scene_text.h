// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Text of a scene as the program passes it on: what it says to the console, and long names in
// messages.

#include <string>
#include <string_view>

namespace candelabra {

/// Makes what a scene says safe to print, as printable() does; line feeds and tabs are kept.
std::string printable_lines(std::string_view text);

/// Returns a name for a message: one of a hundred bytes or more is cut, with `...` in the middle.
std::string clipped(std::string_view name);

}  // namespace candelabra
