// SPDX-License-Identifier: GPL-3.0-or-later
// Where the standard library is: beside an installed program, in the sources for one in its build
// folder, or where the environment variable CANDELABRA_STDLIB says.
#pragma once

#include "text/diagnostic.h"

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

/// The program's own file, as the system knows it; empty when it does not.
std::string own_path();

/// The INI file with the user's or everybody's settings: the first that is there of the one that
/// $CANDELABRA_INI names, ~/.config/candelabra/candelabra.ini and /etc/candelabra/candelabra.ini.
/// None of the current folder, which may be a stranger's. `chosen` and `home`: values of the
/// variables, null when not set.
std::optional<std::string> settings_file(const char* chosen, const char* home);

/// The folder of the standard library, or nothing when there is none. `chosen`: the variable's
/// value, null when it is not set.
std::optional<std::string> standard_library(const std::string& program, const char* chosen);

/// The folders in which files are looked for, in order: the standard library (empty: none), those
/// that the options give, and the pictures of the library. Warns of a folder that is not there.
std::vector<std::string> library_folders(const std::string& standard,
                                         const std::vector<std::string>& given, Diagnostics&);

}  // namespace candelabra
