// SPDX-License-Identifier: GPL-3.0-or-later
// Searches the names that the files of the workspace declare.
#pragma once

#include "editor/workspace.h"

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct Symbol {
    std::string name;
    bool is_macro = false;
    std::string path;
    Part place;
};

/// Returns names that contain the letters of the query in its order, ignoring case. Names that
/// begin with the query come first; the scenes' own names precede the library's that are for
/// scenes. An empty query returns the scenes' own names. At most 1000.
std::vector<Symbol> symbols(Workspace&, std::string_view query);

}  // namespace candelabra
