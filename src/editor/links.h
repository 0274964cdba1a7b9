// SPDX-License-Identifier: GPL-3.0-or-later
// Strings that name files: #include, pictures, fonts, densities, meshes, data.
#pragma once

#include "editor/workspace.h"

#include <string>
#include <vector>

namespace candelabra {

struct Link {
    Part place;  ///< the string without its quotes
    std::string path;
};

/// Of the files that are there, and that a scene may open: an open scene, or the file itself as
/// one. None of them is read.
std::vector<Link> links(Workspace&, const std::string& path);

}  // namespace candelabra
