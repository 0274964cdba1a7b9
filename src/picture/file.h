// SPDX-License-Identifier: GPL-3.0-or-later
// Puts bytes into a file so that others see the old content or the new, never a part, also when
// the machine stops. Called for pictures, states and statistics.
#pragma once

#include "text/diagnostic.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Writes beside the file and renames; pipes, devices and standard output ("-") are written to as
/// they are. False, with a diagnostic, when that fails: then there is no new file, and an old one
/// is as it was.
bool write_file(const std::string& path, std::string_view bytes, Diagnostics&);

/// What would keep write_file() from writing there, as a sentence; empty when nothing is known to.
/// To be asked before long work.
std::string problem_with_destination(const std::string& path);

}  // namespace candelabra
