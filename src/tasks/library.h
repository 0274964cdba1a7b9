// SPDX-License-Identifier: GPL-3.0-or-later
// The location of the standard library: beside an installed program, in the source tree for a
// program in its build folder, or in the folder that the environment variable CANDELABRA_STDLIB
// names.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

/// Returns the path of the program's executable, or empty if the system does not tell.
std::string own_path();

/// Returns the INI file with the settings of the user or of all users: the first existing one of
/// $CANDELABRA_INI, ~/.config/candelabra/candelabra.ini and /etc/candelabra/candelabra.ini. The
/// current folder is not searched, since it may belong to somebody else. `chosen` and `home`:
/// values of the variables, null if unset.
std::optional<std::string> settings_file(const char* chosen, const char* home);

/// Returns the folder of the standard library, or nothing if there is none. `chosen`: the
/// variable's value, null if unset.
std::optional<std::string> standard_library(const std::string& program, const char* chosen);

/// Returns the folder of POV-Ray's own include files, or empty if they are not installed.
std::string installed_povray_library();

/// Returns the folders that the variable CANDELABRA_LIBRARY names, with colons between them. null:
/// it is unset.
std::vector<std::string> named_libraries(const char* chosen);

}  // namespace candelabra
