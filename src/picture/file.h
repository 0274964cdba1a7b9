// SPDX-License-Identifier: GPL-3.0-or-later
// Writes files atomically: other processes, and a machine that restarts after a failure, see the
// old content or the new, never a mixture. Called for pictures, states and statistics.
#pragma once

#include "text/diagnostic.h"
#include "text/opened_file.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Writes a temporary file beside `path` and renames it; pipes, devices and standard output ("-")
/// are written to directly. A link in the place of the file is followed within its folder only,
/// except in /dev and /proc; one that leads nowhere is replaced. On failure, returns false and
/// reports a diagnostic; there is then no new file, and an old one is unchanged.
bool write_file(const std::string& path, std::string_view bytes, Diagnostics&);

/// Opens and empties a file that grows while the program runs, by the same rules for links. Not
/// open on failure.
OpenedFile open_growing_file(const std::string& path);

/// Writes all bytes; returns 0, or the error number of the failure.
int write_all(int descriptor, std::string_view bytes);

/// Says why write_file() would fail for this path, as a clause; empty if no obstacle is known.
/// Meant to be asked before long work.
std::string problem_with_destination(const std::string& path);

}  // namespace candelabra
