// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the sizes in the headers of an OpenEXR file (openexr.com, "OpenEXR File Layout"), since
// OpenEXR reserves the chunk table and tile buffers when it opens a file.
#pragma once

#include <string>
#include <string_view>

namespace candelabra {

/// Describes why the file cannot be as large as it claims; empty if it can.
std::string exr_problem(std::string_view bytes);

}  // namespace candelabra
