// SPDX-License-Identifier: GPL-3.0-or-later
// Where the standard library is: beside an installed program, in the sources for one in its build
// folder, or where the environment variable CANDELABRA_STDLIB says.
#pragma once

#include <optional>
#include <string>

/// The program's own file, as the system knows it; empty when it does not.
std::string own_path();

/// The folder of the standard library, or nothing when there is none. `chosen`: the variable's
/// value, null when it is not set.
std::optional<std::string> standard_library(const std::string& program, const char* chosen);
