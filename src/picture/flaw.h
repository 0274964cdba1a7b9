// SPDX-License-Identifier: GPL-3.0-or-later
// Finds out whether a picture file is whole: copies and full disks leave files that end early, and
// farms leave empty ones. Called before a frame of an animation counts as finished.
#pragma once

#include <string>

namespace candelabra {

/// Returns why the file is not a whole picture of this size in the format that its name says, as a
/// clause; empty if it is one.
std::string flaw_of_picture(const std::string& path, int width, int height);

}  // namespace candelabra
