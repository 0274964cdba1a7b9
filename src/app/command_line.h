// SPDX-License-Identifier: GPL-3.0-or-later
// The command that makes a picture again: what pictures say of their origin. It says what options
// come to, so it is the same however they were given, in INI files or as shards of a farm.
#pragma once

#include "app/options.h"

#include <string>

namespace candelabra {

/// One line of the shell, with the scene's name without its folder. What does not change the
/// pixels is left out: threads, names of outputs, limits, parts of a farm.
std::string command_line(const Options&);

}  // namespace candelabra
