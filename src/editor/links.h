// SPDX-License-Identifier: GPL-3.0-or-later
// Strings that name files: #include, pictures, fonts, densities, meshes and data.
#pragma once

#include "editor/workspace.h"

#include <string>
#include <vector>

namespace candelabra {

struct Link {
    Part place;  ///< the string without its quotes
    std::string path;
};

/// Returns links to existing files that an open scene, or the file itself as a scene, may read.
/// Does not read these files.
std::vector<Link> links(Workspace&, const std::string& path);

}  // namespace candelabra
