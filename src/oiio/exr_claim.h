// SPDX-License-Identifier: GPL-3.0-or-later
// What the heads of an OpenEXR file say of its size (openexr.com, "OpenEXR File Layout"): OpenEXR
// reserves the table of all chunks, and rooms for tiles, when it opens a file.
#pragma once

#include <string>
#include <string_view>

namespace candelabra {

/// Why the file cannot be as large as it says; empty when it can.
std::string exr_problem(std::string_view bytes);

}  // namespace candelabra
