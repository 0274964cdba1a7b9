// SPDX-License-Identifier: GPL-3.0-or-later
// Names that all files of the workspace declare, for a search.
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

/// Those whose names have the letters of the query in its order, in capitals or not: first those
/// that begin with it, and the scenes' own before the library's that are for scenes. For an empty
/// query there are the scenes' own. At most 1000.
std::vector<Symbol> symbols(Workspace&, std::string_view query);

}  // namespace candelabra
