// SPDX-License-Identifier: GPL-3.0-or-later
// Runs other programs.
#pragma once

#include <string>
#include <vector>

namespace candelabra {

/// Returns the path of the program that the shell would find under this name, or "".
std::string find_program(const std::string& name);

/// Runs the program whose path is the first word and waits for it. Returns its exit status, or -1
/// if it could not be run or was ended by a signal.
int run_program(const std::vector<std::string>& words);

}  // namespace candelabra
