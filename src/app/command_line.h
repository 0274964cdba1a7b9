// SPDX-License-Identifier: GPL-3.0-or-later
// The command that makes a picture again, as pictures record it. It is made from the effective
// options, so it is the same whether they were given in INI files, or as shards of a farm.
#pragma once

#include "app/options.h"

#include <string>

namespace candelabra {

/// Returns one line for the shell, with the scene's name without its folder. Options that do not
/// change the pixels are left out: threads, names of outputs, limits, parts of a farm.
std::string command_line(const Options&);

}  // namespace candelabra
