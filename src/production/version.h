// SPDX-License-Identifier: GPL-3.0-or-later
// The name and the version of the program, as pictures record them.
#pragma once

#include <string_view>

namespace candelabra {

/// "0.2.0"
std::string_view version();

/// "Candelabra 0.2.0"
std::string_view program_name();

}  // namespace candelabra
